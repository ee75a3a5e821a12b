#include "post/output/cycle_series.h"

#include <fmt/format.h>

#include <array>
#include <cstddef>

#include "post/output/vtu_text.h"

namespace geneva::post {

using base::Dimension;
using base::OutputUnit;

namespace {

template <std::size_t n>
VtuArray array_of(const std::string& name, const std::vector<std::array<double, n>>& values,
                  const double factor) {
  VtuArray array{name, n, {}};
  for (const auto& value : values)
    for (const double component : value)
      array.values.push_back(static_cast<float>(factor * component));
  return array;
}

VtuArray array_of(const std::string& name, const std::vector<double>& values, const double factor) {
  VtuArray array{name, 1, {}};
  for (const double value : values) array.values.push_back(static_cast<float>(factor * value));
  return array;
}

std::string instant_text(const CycleFields& instant, const OutputUnit& length,
                         const OutputUnit& stress) {
  const NodalFields& fields = instant.fields;
  return vtu_text(fields,
                  {array_of("displacement", fields.displacements, length.factor),
                   array_of("stress", fields.stress, stress.factor),
                   array_of("von_mises", fields.von_mises, stress.factor)},
                  length.factor);
}

std::vector<VtuArray> envelope_arrays(const Envelope& greatest, const OutputUnit& stress,
                                      const SeriesOrder& order) {
  const auto when = [&](const char* const of, const std::vector<double>& values) {
    return array_of(std::string(of) + "_" + order.name, values, order.factor);
  };
  return {array_of("von_mises", greatest.von_mises, stress.factor),
          when("von_mises", greatest.von_mises_when),
          array_of("principal_stress_1", greatest.first_principal, stress.factor),
          when("principal_stress_1", greatest.first_principal_when),
          array_of("max_shear", greatest.max_shear, stress.factor),
          when("max_shear", greatest.max_shear_when),
          array_of("principal_stress_1_least", greatest.tension_least, stress.factor)};
}

}  // namespace

std::map<std::string, std::string> cycle_series(const std::vector<CycleFields>& instants,
                                                const NodalFields& own, const Envelope& greatest,
                                                const SeriesOrder& order,
                                                const std::optional<PressureEnvelope>& pressure,
                                                const base::UnitSystem units) {
  const OutputUnit length = base::output_unit(units, Dimension::length);
  const OutputUnit stress = base::output_unit(units, Dimension::stress);
  std::map<std::string, std::string> texts;
  std::string list =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n";
  for (std::size_t i = 0; i < instants.size(); ++i) {
    const std::string name = fmt::format("{}.{}.vtu", order.files, i);
    texts[name] = instant_text(instants[i], length, stress);
    list += fmt::format("<DataSet timestep=\"{:.9g}\" part=\"0\" file=\"{}\"/>\n",
                        instants[i].when * order.factor, name);
  }
  texts[order.files + ".pvd"] = list + "</Collection>\n</VTKFile>\n";
  std::vector<VtuArray> arrays = envelope_arrays(greatest, stress, order);
  if (pressure) {
    arrays.push_back(array_of("contact_pressure", pressure->pressure, stress.factor));
    arrays.push_back(array_of("contact_pressure_" + order.name, pressure->when, order.factor));
  }
  texts[order.envelope] = vtu_text(own, arrays, length.factor);
  return texts;
}

}  // namespace geneva::post
