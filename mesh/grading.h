#pragma once

namespace geneva::mesh {

/// How the layers of a drawn-out mesh become thinner towards both ends of a contact line, where
/// the pressure changes fast along it: z = h tanh(α ζ/h)/tanh(α) takes even layers in ζ to layers
/// that are 1/cosh²(α) times as thick at z = -h and z = h as in the middle. Beyond the ends they
/// become thicker as they became thinner, up to z = 2 h; from there on z = ζ.
struct Grading {
  double half_length;              ///< h [m], > 0; the line's middle is z = 0
  double thickness_at_ends = 0.5;  ///< over that in the middle, > 0, < 1
};

/// z of an even layer's boundary ζ, both in the unit of the half-length.
double graded(const Grading& grading, double even);

/// ζ of z, the inverse.
double even(const Grading& grading, double graded);

}  // namespace geneva::mesh
