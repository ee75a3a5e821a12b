#pragma once

namespace geneva::mesh {

/// How the layers of a drawn-out mesh become thinner towards both ends of a contact line, where
/// the pressure changes fast along it: z = h sin(π ζ/(3 h))/sin(π/3) takes even layers in ζ to
/// layers that are half as thick at z = -h and z = h as in the middle. Beyond, z = ζ.
struct Grading {
  double half_length;  ///< h [m], > 0; the line's middle is z = 0
};

/// z of an even layer's boundary ζ, both in the unit of the half-length.
double graded(const Grading& grading, double even);

/// ζ of z, the inverse.
double even(const Grading& grading, double graded);

}  // namespace geneva::mesh
