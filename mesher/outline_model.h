#pragma once

#include <array>
#include <map>
#include <vector>

#include "loads/wheel/outline.h"
#include "mesher/model_reader.h"
#include "mesher/size_field.h"

namespace geneva::mesher {

/// Outlines as the current model of Gmsh, in its built-in kernel, with a divided boundary.
///
/// The boundary is divided here and not by Gmsh, which would give every curve an even number of
/// cells; recombination needs only each body's number to be even. Outlines share no points, so that
/// bodies that touch are not welded.
class OutlineModel {
 public:
  /// @param exact the outlines [m]
  /// @param unit the same outlines scaled for Gmsh, vertices in the same order
  /// @param scale metres per unit of length of `unit`
  /// @param size cell sizes in that unit
  /// @param factor on all sizes
  /// The arguments must outlive the model.
  OutlineModel(const std::vector<loads::Outline>& exact, const std::vector<loads::Outline>& unit,
               double scale, const SizeField& size, double factor);

  /// Names of Gmsh's entities; circles in metres.
  [[nodiscard]] const ModelLabels& labels() const { return labels_; }

  /// Puts the vertices that Gmsh has made into metres, those of the boundary exactly onto it.
  void place(TaggedMesh<2>& read) const;

 private:
  /// A curve of Gmsh's model, and how it is divided.
  struct Curve {
    loads::Segment unit;          ///< as Gmsh has it
    const loads::Segment* exact;  ///< part of the outline that it stands for; null: inside the body
    std::array<int, 2> ends;      ///< Gmsh's tags of its points
    std::vector<double> places;   ///< of the vertices between the cells, fractions of its length
  };
  /// Curves of a loop in its order, and the points where they start.
  struct LoopTags {
    std::vector<int> curves;
    std::vector<int> points;
  };

  void add_body(const loads::Outline& unit, const loads::Outline& exact);
  LoopTags add_loop(const loads::Loop& unit, const loads::Loop& exact);
  void add_label(int curve, const loads::Segment& exact);
  void add_ring(const loads::Outline& unit, const std::vector<LoopTags>& loops);
  void add_quadrilateral(const loads::Loop& unit, const LoopTags& loop);
  void divide(const std::vector<LoopTags>& loops);
  [[nodiscard]] int count(double cells) const;
  void add_node(int point);
  void add_lines(int tag, const Curve& curve);
  [[nodiscard]] std::map<std::size_t, loads::Point> boundary_places() const;

  double scale_;
  const SizeField& size_;
  double factor_;
  ModelLabels labels_;
  std::map<int, Curve> curves_;               ///< by Gmsh's tag
  std::map<int, loads::Point> points_;        ///< exact places of the vertices, by Gmsh's tag
  std::map<int, std::size_t> node_of_point_;  ///< before Gmsh has meshed
  std::vector<int> patches_;                  ///< four-sided surfaces, meshed regularly
  std::size_t last_node_ = 0;
};

}  // namespace geneva::mesher
