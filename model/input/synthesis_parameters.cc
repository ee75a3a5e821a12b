#include "loads/pi.h"
#include "model/input/parameter_parts.h"
#include "model/input/parameters.h"

namespace geneva::model {

namespace {

using base::Dimension;

/// Lengths whose squares are numbers.
QuantityRule linkage_length() {
  return quantity(Dimension::length, between(1e-9, 1e6, "from 1 nm to 1000 km"), {""});
}

std::vector<Parameter> quick_return_parameters() {
  const SectionPath section{names::synthesis};
  const std::string only = " Only with Kind = quick return.";
  const Range speed{0., 1e6, false, true, "greater than 0 and at most 1e6 rad/s"};
  return {
      {section, "Stations", "", whole_or_nothing(3, 24, "from 3 to 24"),
       "Number z of stations of the Geneva wheel that is replaced." + only},
      {section, "Maximum wheel speed", "", quantity(Dimension::angular_speed, speed, {""}),
       "Maximum angular speed of the rocker, which is that of the Geneva wheel." + only},
      {section, "Frame", "", linkage_length(),
       "Distance AD of the pivots of crank and rocker. Either the frame or the crank is given." +
           only}};
}

std::vector<Parameter> crank_rocker_parameters() {
  const SectionPath section{names::synthesis};
  const std::string only = " Only with Kind = crank-rocker.";
  const Range swing{0., loads::pi, false, false, "greater than 0 and less than 180 deg"};
  return {{section, "Swing", "", quantity(Dimension::angle, swing, {""}),
           "Angle between the extreme positions of the rocker." + only},
          {section, "Crank pivot distance", "", linkage_length(),
           "From the middle of the chord between the rocker's extreme positions to the crank's "
           "pivot, which lies on the chord produced; greater than half the chord." +
               only}};
}

std::vector<Parameter> path_parameters() {
  const SectionPath section{names::synthesis};
  const std::string only = " Only with Kind = path.";
  return {
      {section, "Points", "points.csv", TextRule{"the name of a file in the case directory"},
       "Comma-separated file with the heading 'x [mm], y [mm]', in any unit of length, and 2 to "
       "9 rows: the points that the coupler passes, in their order." +
           only},
      {section, "Starts", "3000", whole(1, 1e6, "from 1 to 1000000"),
       "How often the search starts from random dimensions: about 0.3 ms each." + only},
      {section, "Seed", "1", whole(0, 4294967295., "from 0 to 4294967295"),
       "Of the random dimensions: the same seed gives the same result." + only}};
}

/// Dimensions of a linkage, given or left to be found.
std::vector<Parameter> linkage_dimension_parameters() {
  const SectionPath section{names::synthesis};
  const QuantityRule place =
      quantity(Dimension::length, between(-1e6, 1e6, "from -1000 to 1000 km"), {""});
  const QuantityRule length = linkage_length();
  const std::string given =
      " With Kind = path as many of the nine dimensions are given as there are points fewer than "
      "nine.";
  return {{section, "Crank pivot x", "", place, "Place of the crank's pivot A." + given},
          {section, "Crank pivot y", "", place, "Place of the crank's pivot A."},
          {section, "Rocker pivot x", "", place, "Place of the rocker's pivot D."},
          {section, "Rocker pivot y", "", place, "Place of the rocker's pivot D."},
          {section, "Crank", "", length, "Crank AB. Not with Kind = crank-rocker."},
          {section, "Coupler", "", length, "Coupler BC. Only with Kind = path."},
          {section, "Rocker", "", length, "Rocker CD. Not with Kind = quick return."},
          {section, "Coupler point distance", "", length,
           "Distance BP of the coupler point from the end of the crank. Only with Kind = path."},
          {section, "Coupler point angle", "", quantity(Dimension::angle, Range(), {""}),
           "Angle from BC to BP, counter-clockwise. Only with Kind = path."}};
}

}  // namespace

std::vector<Parameter> synthesis_parameters() {
  std::vector<Parameter> parameters{
      {{names::synthesis},
       "Kind",
       names::quick_return,
       ChoiceRule{{names::quick_return, names::crank_rocker, names::path}},
       "'quick return': a crank-slider-rocker that moves like an external Geneva. 'crank-rocker': "
       "its rocker swings by a given angle, in equal times forward and back. 'path': a four-bar "
       "linkage whose coupler point passes given points."}};
  append(parameters, quick_return_parameters());
  append(parameters, crank_rocker_parameters());
  append(parameters, path_parameters());
  append(parameters, linkage_dimension_parameters());
  return parameters;
}

}  // namespace geneva::model
