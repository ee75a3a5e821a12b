"""Renders the README's picture: pvbatch doc/images/picture.py RESULTS_DIR PICTURE.png

RESULTS_DIR holds the results of cases/johnson-optimum-wheel (in-lbf units).
"""

import csv
import os
import sys

from paraview.simple import (ColorBy, CreateLayout, CreateView, GetColorTransferFunction, GetScalarBar, PVDReader,
                             SaveScreenshot, Show, Text, AssignViewToLayout)

results, picture = sys.argv[1:3]
reader = PVDReader(FileName=os.path.join(results, "solution.pvd"))
with open(os.path.join(results, "contact.csv"), newline="") as table:
    rows = list(csv.DictReader(table))
loaded = [row for row in rows if row["status"] == "1"]
x = sum(float(row["x [in]"]) for row in loaded) / len(loaded)
y = max(float(row["y [in]"]) for row in loaded)
half_width = (float(loaded[0]["arc_length [in]"]) - float(loaded[-1]["arc_length [in]"])) / -2.0


def panel(title, focus, scale, edges, maximum):
    view = CreateView("RenderView")
    view.UseColorPaletteForBackground = 0
    view.Background = [1.0, 1.0, 1.0]
    view.OrientationAxesVisibility = 0
    display = Show(reader, view)
    display.Representation = "Surface With Edges" if edges else "Surface"
    display.EdgeColor = [0.35, 0.35, 0.35]
    ColorBy(display, ("POINTS", "von_mises"), separate=True)
    colours = GetColorTransferFunction("von_mises", display, separate=True)
    colours.ApplyPreset("Turbo", True)
    colours.RescaleTransferFunction(0.0, maximum)
    bar = GetScalarBar(colours, view)
    bar.Title = "von Mises [psi]"
    bar.ComponentTitle = ""
    bar.TitleColor = bar.LabelColor = [0.0, 0.0, 0.0]
    bar.TitleFontSize = bar.LabelFontSize = 18
    bar.WindowLocation = "Any Location"
    bar.Position = [0.86, 0.3]
    bar.ScalarBarLength = 0.4
    display.SetScalarBarVisibility(view, True)
    text = Show(Text(Text=title), view)
    text.Color = [0.0, 0.0, 0.0]
    text.FontSize = 22
    text.WindowLocation = "Upper Left Corner"
    view.CameraParallelProjection = 1
    view.CameraFocalPoint = [focus[0], focus[1], 0.0]
    view.CameraPosition = [focus[0], focus[1], 10.0]
    view.CameraParallelScale = scale
    return view


views = [panel("Johnson's optimum wheel", (0.5, 0.0), 2.8, False, 4000.0),
         panel("the contact, 10 half-widths wide", (x + 0.4 * half_width, y), 5.0 * half_width, True, 42000.0)]
layout = CreateLayout()
layout.SplitHorizontal(0, 0.5)
AssignViewToLayout(view=views[0], layout=layout, hint=1)
AssignViewToLayout(view=views[1], layout=layout, hint=2)
layout.SetSize(1800, 860)
SaveScreenshot(picture, layout, ImageResolution=[1800, 860])
