#include "cad/dxf_file.h"

#include <dxflib/dl_creationadapter.h>
#include <dxflib/dl_dxf.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "base/errors.h"
#include "base/output_file.h"
#include "loads/pi.h"

namespace geneva::cad {

namespace {

using loads::Loop;
using loads::Outline;
using loads::Point;
using loads::Segment;

/// Lengths that agree to this share of a drawing's size are equal: well above the rounding of
/// sixteen decimals, well below any tolerance of manufacture.
constexpr double same_place = 1e-9;

double direction(const Point& centre, const Point& point) {
  return std::atan2(point.y - centre.y, point.x - centre.x) / loads::degree;
}

bool is_same(const Point& one, const Point& other) { return one.x == other.x && one.y == other.y; }

/// Arcs that follow each other on one circle are one.
Loop with_whole_arcs(const Loop& loop) {
  Loop result;
  for (const Segment& segment : loop) {
    const bool goes_on = !result.empty() && segment.is_arc && result.back().is_arc &&
                         is_same(segment.centre, result.back().centre) &&
                         segment.clockwise == result.back().clockwise &&
                         segment.surface == result.back().surface;
    if (goes_on)
      result.back().end = segment.end;
    else
      result.push_back(segment);
  }
  return result;
}

void write_segment(DL_Dxf& dxf, DL_WriterA& writer, const Segment& segment, const double unit,
                   const DL_Attributes& attributes) {
  const auto in_unit = [&](const double length) { return length / unit; };
  const Point& start = segment.start;
  const Point& end = segment.end;
  if (!segment.is_arc) {
    dxf.writeLine(writer,
                  {in_unit(start.x), in_unit(start.y), 0., in_unit(end.x), in_unit(end.y), 0.},
                  attributes);
    return;
  }
  const Point& centre = segment.centre;
  const double radius = in_unit(std::hypot(start.x - centre.x, start.y - centre.y));
  if (is_same(start, end)) {
    dxf.writeCircle(writer, {in_unit(centre.x), in_unit(centre.y), 0., radius}, attributes);
    return;
  }
  const double from = direction(centre, segment.clockwise ? end : start);
  const double to = direction(centre, segment.clockwise ? start : end);
  dxf.writeArc(writer, {in_unit(centre.x), in_unit(centre.y), 0., radius, from, to}, attributes);
}

/// What stands before the layers and entities of every file of this version.
void write_start(DL_Dxf& dxf, DL_WriterA& writer, const std::vector<Outline>& outlines,
                 const FileUnit unit) {
  constexpr int inches = 1;
  constexpr int millimetres = 4;
  dxf.writeHeader(writer);
  writer.dxfString(9, "$INSUNITS");
  writer.dxfInt(70, unit == FileUnit::inch ? inches : millimetres);
  writer.sectionEnd();
  writer.sectionTables();
  dxf.writeVPort(writer);
  writer.tableLinetypes(3);
  for (const char* const name : {"BYBLOCK", "BYLAYER", "CONTINUOUS"})
    dxf.writeLinetype(writer, {name, name, 0, 0, 0.});
  writer.tableEnd();
  writer.tableLayers(static_cast<int>(outlines.size()) + 1);
  dxf.writeLayer(writer, {"0", 0}, {"", 7, 25, "CONTINUOUS", 1.});
  int colour = 0;
  for (const Outline& outline : outlines)
    dxf.writeLayer(writer, {outline.name, 0}, {"", 1 + colour++ % 6, 25, "CONTINUOUS", 1.});
  writer.tableEnd();
  writer.tableStyle(1);
  dxf.writeStyle(writer, {"Standard", 0, 0., 1., 0., 0, 2.5, "", ""});
  writer.tableEnd();
  dxf.writeView(writer);
  dxf.writeUcs(writer);
  writer.tableAppid(1);
  dxf.writeAppid(writer, "ACAD");
  writer.tableEnd();
  dxf.writeDimStyle(writer, 1., 1., 1., 1., 2.5);
  dxf.writeBlockRecord(writer);
  writer.tableEnd();
  writer.sectionEnd();
  writer.sectionBlocks();
  for (const char* const name : {"*Model_Space", "*Paper_Space", "*Paper_Space0"}) {
    dxf.writeBlock(writer, {name, 0, 0., 0., 0.});
    dxf.writeEndBlock(writer, name);
  }
  writer.sectionEnd();
}

/// Lines, arcs and circles of a drawing by layer, in its own unit.
class Chains : public DL_CreationAdapter {
 public:
  void addLine(const DL_LineData& line) override {
    add({{line.x1, line.y1}, {line.x2, line.y2}, false, {}, false, ""});
  }
  void addArc(const DL_ArcData& arc) override {
    const auto at = [&](const double angle) {
      return Point{arc.cx + arc.radius * std::cos(angle * loads::degree),
                   arc.cy + arc.radius * std::sin(angle * loads::degree)};
    };
    // Green's theorem on arcs needs them shorter than a turn only.
    add({at(arc.angle1), at(arc.angle2), true, {arc.cx, arc.cy}, false, ""});
  }
  void addCircle(const DL_CircleData& circle) override {
    circles_[attributes.getLayer()].push_back(loads::pi * circle.radius * circle.radius);
  }

  /// @throws base::InputError if a chain is not closed
  [[nodiscard]] std::map<std::string, std::vector<double>> areas() const {
    std::map<std::string, std::vector<double>> result = circles_;
    for (const auto& [layer, segments] : segments_)
      for (const Loop& loop : closed(segments, layer))
        result[layer].push_back(std::abs(loads::signed_area(loop)));
    return result;
  }

 private:
  void add(const Segment& segment) { segments_[attributes.getLayer()].push_back(segment); }

  static Segment reversed(Segment segment) {
    std::swap(segment.start, segment.end);
    segment.clockwise = !segment.clockwise;
    return segment;
  }

  static std::vector<Loop> closed(std::vector<Segment> rest, const std::string& layer) {
    const double near = same_place * loads::extent({{layer, {rest}}});
    const auto meet = [&](const Point& one, const Point& other) {
      return std::hypot(one.x - other.x, one.y - other.y) <= near;
    };
    std::vector<Loop> loops;
    while (!rest.empty()) {
      Loop loop{rest.back()};
      rest.pop_back();
      while (!meet(loop.back().end, loop.front().start)) {
        const auto next = std::find_if(rest.begin(), rest.end(), [&](const Segment& segment) {
          return meet(segment.start, loop.back().end) || meet(segment.end, loop.back().end);
        });
        if (next == rest.end())
          throw base::InputError(
              fmt::format("the lines of layer '{}' end at ({:.6g}, {:.6g}): they enclose no area",
                          layer, loop.back().end.x, loop.back().end.y));
        loop.push_back(meet(next->start, loop.back().end) ? *next : reversed(*next));
        rest.erase(next);
      }
      loops.push_back(std::move(loop));
    }
    return loops;
  }

  std::map<std::string, std::vector<Segment>> segments_;
  std::map<std::string, std::vector<double>> circles_;  ///< areas
};

}  // namespace

void write_dxf(const std::filesystem::path& file, const std::vector<Outline>& outlines,
               const FileUnit unit) {
  DL_Dxf dxf;
  const std::unique_ptr<DL_WriterA> writer(dxf.out(file.c_str(), DL_VERSION_2000));
  if (!writer) base::refuse_by_system("cannot write " + file.string());
  write_start(dxf, *writer, outlines, unit);
  writer->sectionEntities();
  constexpr int by_layer = 256;
  for (const Outline& outline : outlines)
    for (const Loop& loop : outline.loops)
      for (const Segment& segment : with_whole_arcs(loop))
        write_segment(dxf, *writer, segment, metres(unit),
                      {outline.name, by_layer, -1, "BYLAYER", 1.});
  writer->sectionEnd();
  dxf.writeObjects(*writer);
  dxf.writeObjectsEnd(*writer);
  writer->dxfEOF();
  writer->close();
  base::synchronise(file);
}

std::map<std::string, double> areas_of_dxf(const std::filesystem::path& file, const FileUnit unit) {
  DL_Dxf dxf;
  Chains chains;
  if (!dxf.in(file.string(), &chains))
    throw base::InputError(file.string() + ": the file cannot be read");
  std::map<std::string, double> result;
  for (const auto& [layer, areas] : chains.areas()) {
    double sum = 0.;
    for (const double area : areas) sum += area;
    const double largest = *std::max_element(areas.begin(), areas.end());
    result[layer] = (2. * largest - sum) * metres(unit) * metres(unit);
  }
  return result;
}

}  // namespace geneva::cad
