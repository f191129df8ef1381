#pragma once
// Shared by the writers of VTK files: field data that describes a file, writing it completely, refusing files
// of other programs. Only for the .cpp files of this folder.

#include "engine/base/result.h"

#include <string>
#include <vector>

class vtkDataSet;
class vtkXMLWriter;

namespace bask::vtkfile {

void addWords(vtkDataSet* data, const char* name, const std::vector<std::string>& words);
void addNumbers(vtkDataSet* data, const char* name, const std::vector<double>& numbers);
/// Adds "made_by", the mark of Bask's own files, and "title".
void addOrigin(vtkDataSet* data, const std::string& title);

/// Writes a temporary file beside the target first; follows links.
Result<void> writeWhole(vtkXMLWriter* writer, vtkDataSet* data, const std::string& path);

/// Refuses an existing, not empty file that is not Bask's own of this VTK type; `kind` is that type in words,
/// marked for translation ("Parameter").
Result<void> checkOwn(const std::string& path, const std::string& type, const char* kind);

} // namespace bask::vtkfile
