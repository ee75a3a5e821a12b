#include "mesher/size_field.h"

#include <algorithm>
#include <cmath>

namespace geneva::mesher {

namespace {

/// Growth of the cell size per length away from a fine place.
constexpr double growth = 0.5;
/// Cells are not longer than this multiple of a narrow place's width.
constexpr double longest_in_narrow_place = 1.25;
/// A narrow place counts if it needs cells smaller than this part of those that are there already.
constexpr double noticeably = 0.8;
constexpr int places_per_segment = 8;
constexpr std::size_t samples = 33;
/// An edge that spans more of a circle would lie far from it.
constexpr double widest_edge = 0.25 * 3.14159265358979323846;

double distance_between(loads::Point a, loads::Point b) { return std::hypot(a.x - b.x, a.y - b.y); }

double distance_to_line(const loads::Segment& line, loads::Point place) {
  const double x = line.end.x - line.start.x;
  const double y = line.end.y - line.start.y;
  const double square = x * x + y * y;
  if (!(square > 0.)) return distance_between(place, line.start);
  const double along = (place.x - line.start.x) * x + (place.y - line.start.y) * y;
  const double t = std::clamp(along / square, 0., 1.);
  return distance_between(place, {line.start.x + t * x, line.start.y + t * y});
}

bool touch(const loads::Segment& a, const loads::Segment& b) {
  const auto same = [](loads::Point p, loads::Point q) { return p.x == q.x && p.y == q.y; };
  return same(a.start, b.start) || same(a.start, b.end) || same(a.end, b.start) ||
         same(a.end, b.end);
}

}  // namespace

double arc_angle(const loads::Segment& segment) {
  const loads::Point a{segment.start.x - segment.centre.x, segment.start.y - segment.centre.y};
  const loads::Point b{segment.end.x - segment.centre.x, segment.end.y - segment.centre.y};
  const double angle = std::abs(std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y));
  return segment.clockwise ? -angle : angle;
}

double length_of(const loads::Segment& segment) {
  if (!segment.is_arc) return distance_between(segment.start, segment.end);
  return distance_between(segment.start, segment.centre) * std::abs(arc_angle(segment));
}

loads::Point point_of(const loads::Segment& segment, double t) {
  if (!segment.is_arc)
    return {segment.start.x + t * (segment.end.x - segment.start.x),
            segment.start.y + t * (segment.end.y - segment.start.y)};
  const double angle = t * arc_angle(segment);
  const double cosine = std::cos(angle);
  const double sine = std::sin(angle);
  const double x = segment.start.x - segment.centre.x;
  const double y = segment.start.y - segment.centre.y;
  return {segment.centre.x + cosine * x - sine * y, segment.centre.y + sine * x + cosine * y};
}

int minimum_cells(const loads::Segment& segment) {
  if (!segment.is_arc) return 1;
  const double rounding = 1e-6;
  const double edges = std::ceil(std::abs(arc_angle(segment)) / widest_edge - rounding);
  return std::max(1, static_cast<int>(edges));
}

SizeField::SizeField(const std::vector<loads::Outline>& outlines, const MeshSizing& sizing)
    : sizing_(sizing) {
  for (const loads::Outline& outline : outlines) {
    std::vector<Shape> shapes;
    for (const loads::Loop& loop : outline.loops)
      for (const loads::Segment& segment : loop) shapes.push_back(shape_of(segment));
    add_fine_segments(shapes);
    add_narrow_places(shapes);
  }
}

SizeField::Shape SizeField::shape_of(const loads::Segment& segment) {
  const loads::Point middle{(segment.start.x + segment.end.x) / 2.,
                            (segment.start.y + segment.end.y) / 2.};
  Shape shape{segment, middle, distance_between(segment.start, middle), {0., 0.}, 0., 0.};
  if (!segment.is_arc) return shape;
  const double off = distance_between(middle, segment.centre);
  shape.radius = distance_between(segment.start, segment.centre);
  shape.towards = {(middle.x - segment.centre.x) / off, (middle.y - segment.centre.y) / off};
  shape.minimum_cosine = std::cos(arc_angle(segment) / 2.);
  return shape;
}

double SizeField::distance(const Shape& shape, loads::Point place) {
  if (!shape.segment.is_arc) return distance_to_line(shape.segment, place);
  const loads::Point centre = shape.segment.centre;
  const double away = distance_between(place, centre);
  const double along =
      (place.x - centre.x) * shape.towards.x + (place.y - centre.y) * shape.towards.y;
  if (along >= shape.minimum_cosine * away) return std::abs(away - shape.radius);
  return std::min(distance_between(place, shape.segment.start),
                  distance_between(place, shape.segment.end));
}

/// Whether the segment is certainly farther away than that: quicker to tell than the distance.
bool SizeField::is_beyond(const Shape& shape, loads::Point place, double distance) {
  const double reach = shape.reach + distance;
  const double x = place.x - shape.middle.x;
  const double y = place.y - shape.middle.y;
  return reach < 0. || x * x + y * y > reach * reach;
}

void SizeField::add_fine_segments(const std::vector<Shape>& shapes) {
  for (const Shape& shape : shapes) {
    const double size = length_of(shape.segment) / minimum_cells(shape.segment);
    if (size < sizing_.general) fine_places_.push_back({shape, size});
  }
  std::sort(fine_places_.begin(), fine_places_.end(),
            [](const FinePlace& a, const FinePlace& b) { return a.size < b.size; });
}

/// Points of the boundary that are near to another segment of the same body.
void SizeField::add_narrow_places(const std::vector<Shape>& shapes) {
  std::vector<FinePlace> found;
  for (const Shape& shape : shapes)
    for (int i = 0; i <= places_per_segment; ++i) {
      const loads::Point place = point_of(shape.segment, i / (1. * places_per_segment));
      double nearest = noticeably * (*this)(place) / longest_in_narrow_place;
      const double enough = nearest;
      for (const Shape& other : shapes) {
        if (is_beyond(other, place, nearest) || touch(shape.segment, other.segment)) continue;
        nearest = std::min(nearest, distance(other, place));
      }
      const loads::Segment point{place, place, false, {0., 0.}, false, ""};
      if (nearest > 0. && nearest < enough)
        found.push_back({shape_of(point), longest_in_narrow_place * nearest});
    }
  fine_places_.insert(fine_places_.end(), found.begin(), found.end());
  std::sort(fine_places_.begin(), fine_places_.end(),
            [](const FinePlace& a, const FinePlace& b) { return a.size < b.size; });
}

std::vector<double> SizeField::cells_along(const loads::Segment& segment) const {
  const double part = length_of(segment) / (samples - 1.);
  std::vector<double> cells{0.};
  for (std::size_t i = 1; i < samples; ++i) {
    const double middle = (static_cast<double>(i) - 0.5) / (samples - 1.);
    cells.push_back(cells.back() + part / (*this)(point_of(segment, middle)));
  }
  return cells;
}

double SizeField::operator()(loads::Point place) const {
  const double slope = (sizing_.general - sizing_.at_contact) / sizing_.contact_distance;
  double size = std::min(sizing_.general,
                         sizing_.at_contact + slope * distance_between(place, sizing_.contact));
  for (const FinePlace& fine : fine_places_) {
    if (fine.size >= size) break;
    if (is_beyond(fine.shape, place, (size - fine.size) / growth)) continue;
    size = std::min(size, fine.size + growth * distance(fine.shape, place));
  }
  return size;
}

}  // namespace geneva::mesher
