#pragma once
// Reads a .vti back as ParaView does.

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkXMLImageDataReader.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace bask::test {

inline vtkSmartPointer<vtkImageData> readImage(const std::string& path) {
    vtkNew<vtkXMLImageDataReader> reader;
    EXPECT_TRUE(reader->CanReadFile(path.c_str())) << path;
    reader->SetFileName(path.c_str());
    reader->Update();
    return reader->GetOutput();
}

inline std::vector<std::string> wordsIn(vtkDataSet* image, const char* name) {
    std::vector<std::string> out;
    auto* array = vtkStringArray::SafeDownCast(image->GetFieldData()->GetAbstractArray(name));
    EXPECT_TRUE(array) << name;
    for (vtkIdType i = 0; array && i < array->GetNumberOfValues(); ++i)
        out.push_back(array->GetValue(i));
    return out;
}

inline std::vector<double> numbersIn(vtkDataSet* image, const char* name) {
    std::vector<double> out;
    vtkDataArray* array = image->GetFieldData()->GetArray(name);
    EXPECT_TRUE(array) << name;
    for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
        out.push_back(array->GetTuple1(i));
    return out;
}

/// All numbers of a point array, tuple after tuple.
inline std::vector<double> samplesIn(vtkDataSet* image, const std::string& name) {
    std::vector<double> out;
    vtkDataArray* array = image->GetPointData()->GetArray(name.c_str());
    EXPECT_TRUE(array) << name;
    for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
        for (int c = 0; c < array->GetNumberOfComponents(); ++c)
            out.push_back(array->GetComponent(i, c));
    return out;
}

} // namespace bask::test
