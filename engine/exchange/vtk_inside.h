#pragma once
// What the writers of VTK files share: field data that explains a file, writing it whole, refusing others'
// files. For this folder's .cpp files alone.

#include "engine/base/result.h"

#include <string>
#include <vector>

class vtkDataSet;
class vtkXMLWriter;

namespace bask::vtkfile {

void addWords(vtkDataSet* data, const char* name, const std::vector<std::string>& words);
void addNumbers(vtkDataSet* data, const char* name, const std::vector<double>& numbers);
/// "made_by", the mark of Bask's own files, and "title".
void addOrigin(vtkDataSet* data, const std::string& title);

/// Through a temporary beside it, where a link leads.
Result<void> writeWhole(vtkXMLWriter* writer, vtkDataSet* data, const std::string& path);

/// Refuses a file that is there, not empty and not of Bask's own of VTK's type; `kind` is that in words.
Result<void> checkOwn(const std::string& path, const std::string& type, const char* kind);

} // namespace bask::vtkfile
