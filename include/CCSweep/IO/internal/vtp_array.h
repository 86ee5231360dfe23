// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_IO_INTERNAL_VTP_ARRAY_H
#define CCSWEEP_IO_INTERNAL_VTP_ARRAY_H

#include <string>

namespace CCSweep::internal {

// VTK's XML PolyData, in text: a file is a head, which tells the numbers of its one piece, arrays, and a tail.
inline std::string vtp_head(const std::string& numbers) {
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
         "<PolyData>\n<Piece " +
         numbers + ">\n";
}

inline std::string vtp_array(const char* type, const char* name, const std::string& values, const char* more = "") {
  return std::string("<DataArray type=\"") + type + "\" Name=\"" + name + "\"" + more + " format=\"ascii\">\n" +
         values + "</DataArray>\n";
}

inline std::string vtp_tail() { return "</Piece>\n</PolyData>\n</VTKFile>\n"; }

}  // namespace CCSweep::internal

#endif
