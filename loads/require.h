#pragma once

namespace geneva::loads {

// Each refuses a value by std::invalid_argument that names the quantity, the value found (lengths
// in mm), what is allowed and what to change.

/// @param length [m]
void require_positive_length(const char* quantity, double length);
/// @param unit of the value; empty if it has none
void require_positive(const char* quantity, double value, const char* unit);
void require_not_negative(const char* quantity, double value, const char* unit);
void require_finite(const char* quantity, double value, const char* unit);
/// Stations from 3 (the geometric limit) to 24 (beyond, the locking arcs are too short to hold).
/// @returns the stations
int require_stations(int stations);

}  // namespace geneva::loads
