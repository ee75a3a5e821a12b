"""Renders the README's picture in 3-D: pvbatch doc/images/pin_picture.py RESULTS_DIR PICTURE.png

RESULTS_DIR holds the results of cases/johnson-optimum-3d (in-lbf units). The contact zone is drawn 25 times as wide as
it is; the pressure stands on it as a mountain.
"""

import csv
import os
import sys

from paraview.simple import (Clip, ColorBy, CreateView, GetColorTransferFunction, GetScalarBar, SaveScreenshot, Show,
                             Transform, WarpByScalar, XMLUnstructuredGridReader)

results, picture = sys.argv[1:3]
with open(os.path.join(results, "contact.csv"), newline="") as table:
    loaded = [row for row in csv.DictReader(table) if row["status"] == "1"]
middle = sum(float(row["x [in]"]) for row in loaded) / len(loaded)
highest = max(float(row["contact_pressure [psi]"]) for row in loaded)
HALF_WIDTH, STRETCH, HEIGHT = 0.006, 25.0, 0.26

reader = XMLUnstructuredGridReader(FileName=[os.path.join(results, "contact.vtu")])
zone = Clip(Input=reader, ClipType="Box", Invert=1)
zone.ClipType.Position = [middle - HALF_WIDTH, -10.0, -10.0]
zone.ClipType.Length = [2.0 * HALF_WIDTH, 20.0, 20.0]
wide = Transform(Input=zone)
wide.Transform.Scale = [STRETCH, 1.0, 1.0]
mountain = WarpByScalar(Input=wide, Scalars=["POINTS", "contact_pressure"], UseNormal=1, Normal=[0.0, 1.0, 0.0],
                        ScaleFactor=HEIGHT / highest)

view = CreateView("RenderView")
view.ViewSize = [1400, 620]
view.UseColorPaletteForBackground = 0
view.Background = [1.0, 1.0, 1.0]
view.OrientationAxesVisibility = 0
display = Show(mountain, view)
display.Ambient, display.Diffuse, display.Specular = 0.45, 0.65, 0.0
ColorBy(display, ("POINTS", "contact_pressure"))
colours = GetColorTransferFunction("contact_pressure")
colours.ApplyPreset("Viridis (matplotlib)", True)
colours.RescaleTransferFunction(0.0, highest)
display.SetScalarBarVisibility(view, True)
bar = GetScalarBar(colours, view)
bar.Title, bar.ComponentTitle = "contact pressure [psi]", ""
bar.TitleColor = bar.LabelColor = [0.0, 0.0, 0.0]
bar.LabelFormat = bar.RangeLabelFormat = "%.0f"
bar.WindowLocation = "Any Location"
bar.Position = [0.85, 0.25]
view.CameraParallelProjection = 1
view.CameraPosition = [middle * STRETCH - 0.9, 1.4, 1.35]
view.CameraFocalPoint = [middle * STRETCH, 0.4, 0.0]
view.CameraViewUp = [0.0, 1.0, 0.0]
view.ResetCamera()
view.CameraParallelScale = 0.3
SaveScreenshot(picture, view)
