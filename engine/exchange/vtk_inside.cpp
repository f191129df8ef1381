#include "engine/exchange/vtk_inside.h"

#include "engine/base/hidden_folder.h"
#include "engine/base/message_code.h"
#include "engine/base/version.h"

#include <vtkCallbackCommand.h>
#include <vtkDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkStringArray.h>
#include <vtkXMLWriter.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace bask::vtkfile {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMark = "Name=\"made_by\"";
constexpr std::size_t kMarkWithin = 4096; // bytes from the start

/// Nothing, or why it could not be written.
std::string writeData(vtkXMLWriter* writer, vtkDataSet* data, const std::string& path) {
    vtkNew<vtkCallbackCommand> silent; // with an observer VTK prints nothing of its own
    silent->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
    writer->AddObserver(vtkCommand::ErrorEvent, silent);
    writer->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, silent);
    writer->SetFileName(path.c_str());
    writer->SetInputData(data);
    writer->SetHeaderTypeToUInt64();
    writer->SetDataModeToAppended();
    writer->EncodeAppendedDataOff();
    writer->SetCompressorTypeToNone(); // it would take longer than the sampling
    const bool done = writer->Write() == 1;
    if (writer->GetErrorCode() == vtkErrorCode::OutOfDiskSpaceError)
        return std::strerror(ENOSPC);
    if (writer->GetErrorCode() != vtkErrorCode::NoError)
        return vtkErrorCode::GetStringFromErrorCode(writer->GetErrorCode());
    return done ? "" : "VTK does not say why";
}

} // namespace

void addWords(vtkDataSet* data, const char* name, const std::vector<std::string>& words) {
    vtkNew<vtkStringArray> array;
    array->SetName(name);
    for (const std::string& word : words)
        array->InsertNextValue(word);
    data->GetFieldData()->AddArray(array);
}

void addNumbers(vtkDataSet* data, const char* name, const std::vector<double>& numbers) {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    for (const double number : numbers)
        array->InsertNextValue(number);
    data->GetFieldData()->AddArray(array);
}

void addOrigin(vtkDataSet* data, const std::string& title) {
    addWords(data, "made_by", {"Bask " BASK_VERSION});
    addWords(data, "title", {title});
}

Result<void> writeWhole(vtkXMLWriter* writer, vtkDataSet* data, const std::string& path) {
    const fs::path target = behindLinks(path);
    const auto hidden = HiddenFolder::in(folderOfFile(target.string()));
    if (!hidden)
        return Error(MessageCode::FileUnwritable, path, hidden.error().message.args);
    const std::string temporary = hidden->place(target.filename().string());
    std::string reason = writeData(writer, data, temporary);
    if (reason.empty()) {
        std::error_code failed;
        fs::rename(temporary, target, failed);
        if (failed)
            reason = failed.message();
    }
    return reason.empty() ? Result<void>() : Error(MessageCode::FileUnwritable, path, {reason});
}

Result<void> checkOwn(const std::string& path, const std::string& type, const char* kind) {
    std::error_code failed;
    if (!fs::exists(path, failed) || (fs::file_size(path, failed) == 0 && !failed))
        return {};
    std::ifstream file(path, std::ios::binary);
    std::string start(kMarkWithin, '\0');
    file.read(start.data(), static_cast<std::streamsize>(start.size()));
    if (!start.starts_with("<VTKFile type=\"" + type + '"') || start.find(kMark) == std::string::npos)
        return Error(MessageCode::OutputForeign, path, {kind});
    return {};
}

} // namespace bask::vtkfile
