"""Changes of a file's bytes that nobody intends: each function takes a random.Random, and changes alike for alike."""

import dataclasses
import re
import struct

NUMBER = re.compile(rb"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
WORD = re.compile(rb"[A-Za-z_][A-Za-z_0-9]*|[-+]?[\d.]+(?:[eE][-+]?\d+)?|\"[^\"\n]*\"|[^\sA-Za-z_0-9]")
ASSIGNMENT = re.compile(rb"(?m)^(\s*set [^=\n]*=)[^\n]*$")

EXTREMES = [b"0", b"-0", b"-1", b"1", b"2", b"3", b"1e-300", b"1e300", b"-1e308", b"1e999", b"5e-324", b"nan", b"inf",
            b"-inf", b"0x10", b"1e-9", b"1e9", b"127", b"255", b"65536", b"2147483647", b"2147483648", b"-2147483648",
            b"4294967295", b"4294967296", b"9223372036854775808", b"18446744073709551615", b"1,5", b"1.5.2", b"--1",
            b".", b"1e", b"+1", b"0.1e1", b"3.", b"1" * 400, b"0." + b"3" * 400]
FACTORS = [0.5, 0.8, 0.9, 0.999, 1.001, 1.1, 1.25, 2.0, 3.0, 10.0, 0.1]
FAR_FACTORS = [0.0, -1.0, 0.5, 0.9, 0.999999, 1.000001, 1.1, 2.0, 10.0, 1e-3, 1e3, 1e-6, 1e6]
BYTES = [b"\0", b"\xff", b"\n", b"\r", b"\t", b" ", b"#", b"\\", b"=", b'"', b"{", b"}", b";", b"%n", b"\xc3\xa9",
         b"\xe2\x80\xae", b"\x1b[2J", b"\xef\xbb\xbf", b"\x7f", b"/*", b"//"]
UNITS = [b"mm", b"m", b"in", b"km", b"nm", b"N", b"lbf", b"Pa", b"MPa", b"psi", b"rpm", b"deg", b"rad", b"s", b"ms",
         b"%", b"kg", b"kg.m^2", b"N.m", b"lbf.in", b"kg/m^3", b"GB", b"h", b"K", b"degC", b"1", b"m^99999999999",
         b"(m", b"m/s/s/s", b"dB", b"lg(re 1 mW)", b"day since 2000-01-01", b"@", b"mmmm", b"N N N", b"e", b"\xc2\xb5m"]
VALUES = [b"", b"none", b"fixed", b"table", b"yes", b"default", b"1", b"0", b"-1", b"geometry.geo", b"..", b"/", b".",
          b"/dev/zero", b"/etc/passwd", b"case.prm", b"results", b"a, b, c", b",", b", ,", b"a -> b", b"->", b"a: x, a: x",
          b"x" * 5000, b"%s%n%d", b"$(id)", b"{}", b"{0}", b"${HOME}", b"a\\", b"three", b"1 2 3", b"0, 0", b"nan, nan"]
ALIKE = [[b"mm", b"m", b"in", b"cm", b"km", b"um", b"ft"], [b"N", b"kN", b"lbf", b"mN"], [b"Pa", b"MPa", b"GPa", b"psi", b"bar"],
         [b"rpm", b"rad/s", b"deg/s", b"Hz"], [b"deg", b"rad"], [b"s", b"ms", b"h"], [b"N.m", b"lbf.in", b"N.mm"],
         [b"kg.m^2", b"lb.in^2", b"g.mm^2"], [b"kg/m^3", b"lb/in^3", b"g/cm^3"]]
CHOICES = {b"Plane": [b"plane strain", b"plane stress", b"axisymmetric"], b"Dimension": [b"2", b"3"],
           b"Output units": [b"SI", b"mm-N", b"in-lbf"], b"Contact model": [b"local", b"full wheel"],
           b"Type": [b"external", b"internal", b"spherical", b"long dwell", b"four-bar", b"force", b"pressure", b"displacement"],
           b"Driver angle": [b"at maximum wheel acceleration", b"at maximum pin force", b"-10 deg", b"0 deg", b"30 deg"],
           b"Driver motion": [b"constant", b"cycloidal on the carrier", b"harmonic on the cross", b"table"],
           b"Wheel inertia": [b"Johnson", b"from geometry", b"0 kg.m^2", b"1 kg.m^2"], b"Pins": [b"1", b"2", b"3"],
           b"Pin angles": [b"0 deg, 120 deg", b"0 deg, 1 deg", b"0 deg, 0 deg"], b"External torque": [b"1 N.m", b"-1 N.m"],
           b"Slot friction": [b"0", b"0.1", b"1"], b"Pin type": [b"fixed", b"roller"], b"Roller bore diameter": [b"3 mm"],
           b"Held at": [b"one end", b"both ends", b"core"], b"Profile": [b"cylindrical", b"crown", b"logarithmic", b"table"],
           b"Tilt": [b"0.1 deg", b"-5 deg", b"80 deg"], b"Slot edge": [b"sharp", b"rounded", b"chamfered"], b"Slot edge size": [b"0.2 mm", b"100 mm"],
           b"Supports": [b"block bottom: fixed", b"lower bottom: y", b"", b"lower bottom: fixed, upper top: y"],
           b"Poisson's ratio": [b"0", b"0.4999", b"0.5", b"-0.9"], b"Friction moment": [b"0 N.m", b"-1 N.m", b"1e6 N.m"],
           b"Kind": [b"quick return", b"crank-rocker", b"path"], b"Stations": [b"3", b"4", b"5", b"24"],
           b"Circle tolerance": [b"0", b"1e-3", b"1"], b"Linear tolerance": [b"1e-3", b"1e-14"], b"Direction": [b"0, 0", b"0, 1", b"1, -1"]}
SECTIONS = [b"Mechanism", b"Geometry", b"Synthesis", b"Published", b"Allowable", b"Pin", b"Pin material", b"Design",
            b"Body", b"Body x", b"Load", b"Load x", b"Contact pair 1", b"Linkage"]

# What Gmsh's language can do that a drawing of two bodies has no use for.
STATEMENTS = [
    b"Mesh 2;", b"Mesh 3;", b"RefineMesh;", b"SetOrder 2;", b"Mesh.ElementOrder = 2;", b"Coherence;", b"Coherence Mesh;",
    b"OptimizeMesh \"Netgen\";", b"PartitionMesh 3;", b"RecombineMesh;", b"ClassifySurfaces {0.7, 1};",
    b"CreateGeometry;", b"CreateTopology;", b"Homology {1, 2};", b"Delete Model;", b"Delete Physicals;", b"Delete All;",
    b"Delete Meshes;", b"Delete Options;", b"Delete { Surface{101}; }", b"Recursive Delete { Surface{201}; }",
    b"Delete Physical Surface(1);", b"Mesh.MeshSizeFactor = 1e-9;", b"Mesh.MeshSizeMax = 1e-12;", b"Mesh.Algorithm = 9;",
    b"Mesh.Algorithm3D = 4;", b"Mesh.RecombineAll = 0;", b"Mesh.SubdivisionAlgorithm = 2;", b"Mesh.SaveAll = 1;",
    b"Mesh.Renumber = 0;", b"Mesh.MeshOnlyVisible = 1; Hide {:}", b"Mesh.Smoothing = 100;", b"Mesh.RandomFactor = 1e9;",
    b"Geometry.Tolerance = 1e9;", b"Geometry.ScalingFactor = 0;", b"Geometry.ScalingFactor = -1e300;",
    b"General.Terminal = 1;", b"General.Verbosity = 99;", b"General.AbortOnError = 3;", b"General.NumThreads = 1000;",
    b"General.ErrorFileName = \"escaped\";", b"General.LogFileName = \"escaped.log\";", b"General.TmpFileName = \"escaped\";",
    b"For i In {1:1e9}\nEndFor", b"For i In {1:3}", b"EndFor", b"If (1)", b"EndIf", b"Else", b"Macro M\n Call M;\nReturn\nCall M;",
    b"Return", b"Call nothing;", b"x[] = {1:1e7};", b"x[] = {1}; x[-7] = 1;", b"x[] = {1}; y = x[123456789];",
    b"x[] = {}; y = x[0];", b"y = 1 / 0; Point(999) = {y, 0, 0};", b"y = Sqrt(-1); Point(999) = {y, 0, 0};",
    b"Printf(\"%s %n %g\", 1);", b"Printf(\"%n%n%n%n\");", b"Error(\"%s\", 1);", b"Warning(\"a\nb\nc\nd\ne\");",
    b"Printf(\"out of memory\");", b"s = Str[{1, 2}]; Printf(s);", b"s = StrCat(\"a\", s);", b"s = StrReplace(\"a\", \"\", \"b\");",
    b"s = StrSub(\"abc\", -5, 1000); Printf(s);", b"Parse \"Point(999) = {0, 0, 0};\";", b"UnitTest;", b"Merge \"case.prm\";",
    b"Merge \"/etc/passwd\";", b"Merge \"geometry.geo\";", b"Include \"geometry.geo\";", b"Include \"../../nothing.geo\";",
    b"Merge \"/dev/zero\";", b"ShapeFromFile(\"/dev/null\");", b"Save \"escaped.msh\";", b"SystemCall \"touch escaped\";",
    b"Print \"escaped.png\";", b"Exit;", b"Abort;", b"Plugin(NewView).Run;", b"View \"v\" { SP(0,0,0){1}; };",
    b"View[0].Visible = 1;", b"Background Mesh View[0];", b"Field[1] = MathEval; Field[1].F = \"1/0\"; Background Field = 1;",
    b"Field[1] = Distance; Field[1].CurvesList = {-1, 999}; Background Field = 1;", b"Field[1] = Attractor;",
    b"Field[1] = Restrict; Field[1].InField = 1; Background Field = 1;", b"Background Field = 77;",
    b"Field[1] = PostView; Field[1].ViewIndex = 9; Background Field = 1;", b"SetFactory(\"OpenCASCADE\");",
    b"SetFactory(\"nothing\");", b"Rectangle(999) = {0, 0, 0, 1, 1};", b"Box(999) = {0, 0, 0, 1, 1, 1};", b"Sphere(999) = {0, 0, 0, -1};",
    b"BooleanUnion{ Surface{101}; Delete; }{ Surface{201}; Delete; }", b"BooleanFragments{ Surface{:}; }{ }",
    b"Rotate {{0, 0, 0}, {0, 0, 0}, Pi} { Surface{101}; }", b"Dilate {{0, 0, 0}, 0} { Surface{101}; }",
    b"Symmetry {0, 0, 0, 0} { Surface{101}; }", b"Translate {1e300, 0, 0} { Point{:}; }", b"Translate {0, 0, 1} { Surface{201}; }",
    b"Extrude {0, 0, 1} { Surface{101}; Layers{3}; Recombine; }", b"Extrude {0, 0, 1} { Surface{101}; Layers{0}; }",
    b"Extrude {0, 0, 0} { Line{101}; }", b"Extrude {{0, 0, 0}, {0, 0, 0}, 0} { Line{101}; }", b"Physical Surface(\"upper\") = {201};",
    b"Physical Surface(\"upper\") += {101, 201};", b"Physical Curve(\"x\") = {101, -101};", b"Physical Curve(\"\", 77) = {103};",
    b"Physical Curve(\"x\", -7) = {103};", b"Physical Curve(\"x\", 2147483648) = {103};", b"Physical Point(\"p\") = {101};",
    b"Physical Volume(\"v\") = {1};", b"Physical Surface(101) = {101};", b"Physical Curve(\"a\x1b[2Jb\") = {103};",
    b"Compound Curve {101, 102};", b"Compound Surface {101, 201};", b"Periodic Curve {101} = {103};", b"Periodic Curve {101} = {-101};",
    b"Periodic Surface {101} = {201} Translate {0, 1, 0};", b"Point{101} In Surface{201};", b"Curve{201} In Surface{101};",
    b"Embed Point{101};", b"Transfinite Curve {:} = 0;", b"Transfinite Curve {:} = -5;", b"Transfinite Curve {:} = 300 Using Progression 1e9;",
    b"Transfinite Curve {:} = 5 Using Bump -1;", b"Transfinite Surface {101} = {1, 2, 3};", b"Transfinite Volume {:};",
    b"Recombine Surface {:};", b"Reverse Surface {:};", b"Reverse Curve {:};", b"Spline(999) = {101};", b"BSpline(999) = {101, 101};",
    b"Bezier(999) = {};", b"Circle(999) = {101, 101, 101};", b"Ellipse(999) = {101, 102, 103, 104};", b"Line(101) = {102, 103};",
    b"Line(999) = {101, 101};", b"Line(999) = {101, 12345};", b"Curve Loop(999) = {};", b"Curve Loop(999) = {101, 101};",
    b"Plane Surface(999) = {};", b"Plane Surface(999) = {101, 101, 201};", b"Surface(999) = {101};", b"Surface Loop(999) = {101};",
    b"Volume(999) = {999};", b"Point(101) = {5, 5, 5};", b"Point(-1) = {0, 0, 0};", b"Point(999) = {0, 0, 0, 1e-300};",
    b"Point(1e10) = {0, 0, 0};", b"DefineConstant[ n = {1, Min 0, Max 0, Step 0, Name \"a/b\"} ];", b"n = GetNumber(\"x\");",
    b"s = GetEnv(\"HOME\"); Printf(s);", b"SetName \"x\";", b"NewModel;", b"Solver.AutoMesh = 2;", b"OnelabRun(\"x\");",
    b"Alias View[0];", b"Combine Views;", b"Characteristic Length {:} = 0;", b"Mesh.MeshSizeFromCurvature = 1e9;",
    b"MeshAlgorithm Surface {101} = 77;", b"Color Red { Surface{101}; }", b"BoundingBox {0, 0, 0, 0, 0, 0};", b"Draw;", b"{", b"}", b"\"", b"/*"]

DOUBLES = [0.0, -0.0, float("nan"), float("inf"), float("-inf"), 1e300, -1e300, 1e-300, 5e-324, 1.0, -1.0]
INTEGERS = [0, 1, 2, 3, 5, 15, 16, 93, 127, 128, 255, 65536, 2**31 - 1, 2**31, 2**32 - 1]
LONG_INTEGERS = [2**32, 2**61, 2**63 - 1, 2**63, 2**64 - 1]


def spliced(data, start, end, new):
    return data[:start] + new + data[end:]


# Of any file


def change_bytes(rng, data):
    """Overwrites, inserts or removes a few bytes."""
    for _ in range(rng.choice((1, 1, 2, 4, 8))):
        place = rng.randrange(len(data) + 1)
        new = rng.choice(BYTES) if rng.random() < 0.5 else bytes([rng.randrange(256)])
        data = spliced(data, place, place + rng.choice((0, 1, len(new))), b"" if rng.random() < 0.2 else new)
    return data


def cut(rng, data):
    """Ends the file early, or takes out or repeats a stretch of it."""
    start = rng.randrange(len(data) + 1)
    end = min(len(data), start + rng.randrange(1, 200))
    return rng.choice((data[:start], spliced(data, start, end, b""), data[:end] + data[start:]))


# Of texts


def replace_match(rng, data, pattern, replacement):
    """Replaces one place that fits a pattern."""
    found = list(pattern.finditer(data))
    if not found:
        return change_bytes(rng, data)
    match = rng.choice(found)
    return spliced(data, *match.span(), replacement(match))


def written(value):
    return b"%d" % int(value) if value == int(value) and abs(value) < 1e15 else repr(value).encode()


def scaled_number(rng, text):
    """One that is not far from it, of a whole number another whole one."""
    value = float(text)
    if value == int(value) and rng.random() < 0.6:
        return written(value + rng.choice((-2, -1, 1, 2)))
    return written(value * rng.choice(FACTORS))


def changed_number(rng, text):
    if rng.random() < 0.5:
        return rng.choice(EXTREMES)
    try:
        value = float(text)
    except ValueError:
        return rng.choice(EXTREMES)
    if rng.random() < 0.4:
        value += rng.choice((-1, 1))
    else:
        value *= rng.choice(FAR_FACTORS)
    return written(value)


def change_number(rng, data):
    return replace_match(rng, data, NUMBER, lambda match: changed_number(rng, match.group()))


def scale_number(rng, data):
    return replace_match(rng, data, NUMBER, lambda match: scaled_number(rng, match.group()))


def remove_statement(rng, data):
    """Takes out a line that stands for itself."""
    return replace_match(rng, data, re.compile(rb"(?m)^\s*(?:set [^\n]*|[A-Z][^\n]*;)\n"), lambda _: b"")


def change_word(rng, data):
    """Puts one word of the file in the place of another, or takes it out."""
    words = WORD.findall(data) or [b"x"]
    return replace_match(rng, data, WORD, lambda _: rng.choice(words) if rng.random() < 0.8 else b"")


def change_lines(rng, data):
    """Removes, repeats, exchanges, joins or moves lines."""
    lines = data.split(b"\n")
    i, k = rng.randrange(len(lines)), rng.randrange(len(lines))
    change = rng.randrange(5)
    if change == 0:
        del lines[i]
    elif change == 1:
        lines.insert(k, lines[i])
    elif change == 2:
        lines[i], lines[k] = lines[k], lines[i]
    elif change == 3:
        lines[i:i + 2] = [b" ".join(lines[i:i + 2])]
    else:
        lines.insert(k, lines.pop(i))
    return b"\n".join(lines)


# Of case files


def change_unit(rng, data):
    after_number = re.compile(rb"(?<=[\d.] )[^\s,\n]+")
    return replace_match(rng, data, after_number, lambda _: rng.choice(UNITS))


def change_unit_alike(rng, data):
    """Another unit of the same quantity."""
    units = {unit: group for group in ALIKE for unit in group}
    pattern = re.compile(rb"(?<=[\d.] )(?:" + b"|".join(map(re.escape, sorted(units, key=len, reverse=True))) + rb")(?=[\n,])")
    return replace_match(rng, data, pattern, lambda match: rng.choice(units[match.group()]))


def choose(rng, data):
    """Another word for a parameter that has one, or one more parameter."""
    name = rng.choice(sorted(CHOICES))
    line = b"set %s = %s" % (name, rng.choice(CHOICES[name]))
    there = re.compile(rb"(?m)^\s*set " + re.escape(name) + rb" *=[^\n]*$")
    if there.search(data):
        return replace_match(rng, data, there, lambda _: line)
    return replace_match(rng, data, ASSIGNMENT, lambda match: match.group() + b"\n" + line)


def change_value(rng, data):
    """Another value for a parameter: any, or that of another one."""
    others = [match.group().split(b"=", 1)[1] for match in ASSIGNMENT.finditer(data)] or [b""]
    return replace_match(rng, data, ASSIGNMENT,
                         lambda match: match.group(1) + b" " + rng.choice(rng.choice((VALUES, others))))


def change_sections(rng, data):
    """Moves, renames, opens or closes a subsection."""
    blocks = re.split(rb"(?m)^(?=\s*subsection )", data)
    change = rng.randrange(4)
    if change == 0:
        rng.shuffle(blocks)
        return b"".join(blocks)
    if change == 1:
        return replace_match(rng, data, re.compile(rb"subsection [^\n]*"), lambda _: b"subsection " + rng.choice(SECTIONS))
    if change == 2:
        return replace_match(rng, data, re.compile(rb"\n"), lambda _: b"\nsubsection " + rng.choice(SECTIONS) + b"\n")
    return replace_match(rng, data, re.compile(rb"\n\s*end\n|\n"), lambda match: b"\n" if len(match.group()) > 1 else b"\nend\n")


# Of geometries


def add_statement(rng, data):
    """Adds a statement of Gmsh's language after one of the lines, often the last one."""
    statement = rng.choice(STATEMENTS) + b"\n"
    if rng.random() < 0.4:
        return data.rstrip(b"\n") + b"\n" + statement
    return replace_match(rng, data, re.compile(rb"\n"), lambda _: b"\n" + statement)


# Of binary files


def change_binary_number(rng, data):
    """Writes another number where one may stand: numbers of 4 and 8 bytes."""
    if rng.random() < 0.4:
        new = struct.pack("<d", rng.choice(DOUBLES))
    elif rng.random() < 0.4:
        new = struct.pack("<Q", rng.choice(INTEGERS + LONG_INTEGERS))
    else:
        new = struct.pack("<I", rng.choice(INTEGERS))
    start = rng.randrange(max(1, len(data) - len(new)))
    return spliced(data, start, start + len(new), new)


def scale_binary_number(rng, data):
    """Scales what may be a coordinate, or adds one to what may be an index."""
    places = [place for place in (rng.randrange(max(1, len(data) - 8)) for _ in range(200))
              if 1e-3 < abs(struct.unpack_from("<d", data, place)[0]) < 1e6]
    if not places or rng.random() < 0.3:
        place = rng.randrange(len(data))
        return spliced(data, place, place + 1, bytes([(data[place] + rng.choice((-1, 1))) % 256]))
    value = struct.unpack_from("<d", data, places[0])[0] * rng.choice((-1.0, 0.0, *FACTORS))
    return spliced(data, places[0], places[0] + 8, struct.pack("<d", value))


# By the kind of the file: what leaves it a file of its kind that may get far, and what does not ask for that.
@dataclasses.dataclass(frozen=True)
class Changes:
    mild: tuple
    harsh: tuple


CASE = Changes((scale_number, scale_number, scale_number, change_unit_alike, choose, choose, remove_statement),
               (change_bytes, cut, change_lines, change_word, change_number, change_number, change_unit, change_unit,
                change_value, change_value, change_sections))
GEOMETRY = Changes((scale_number, scale_number, add_statement, remove_statement),
                   (change_bytes, cut, change_lines, change_word, change_number, add_statement, add_statement))
MESH_TEXT = Changes((scale_number,), (change_bytes, cut, change_lines, change_word, change_number, change_number))
MESH_BINARY = Changes((scale_binary_number,),
                      (change_bytes, cut, change_binary_number, change_binary_number, change_number))


def mutate(rng, data, changes):
    """Some changes one after the other: mild ones, or few harsh ones, since more of them are noticed too early."""
    is_mild = rng.random() < 0.6
    for _ in range(rng.choice((1, 1, 2, 3) if is_mild else (1, 1, 1, 2, 5))):
        data = rng.choice(changes.mild if is_mild else changes.harsh)(rng, data)
    return data
