#pragma once
// A piece of a scene: an actor with its own geometry. Inside widgets/scene only.

#include "engine/base/pose.h"

#include <QColor>

#include <vtkActor.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkSmartPointer.h>

namespace bask {

/// Unlit: the given colour is the visible colour.
struct ScenePart {
    vtkSmartPointer<vtkPolyData> data = vtkSmartPointer<vtkPolyData>::New();
    vtkSmartPointer<vtkPolyDataMapper> mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
    vtkSmartPointer<vtkActor> actor = vtkSmartPointer<vtkActor>::New();
    float width_px = 1.0F;

    ScenePart() {
        mapper->SetInputData(data);
        mapper->ScalarVisibilityOff();
        actor->SetMapper(mapper);
        actor->PickableOff();
        actor->GetProperty()->LightingOff();
    }

    void setColour(const QColor& colour) {
        actor->GetProperty()->SetColor(colour.redF(), colour.greenF(), colour.blueF());
    }
    void setTransform(const Pose& X) {
        vtkNew<vtkMatrix4x4> matrix;
        for (int row = 0; row < 4; ++row)
            for (int column = 0; column < 4; ++column)
                matrix->SetElement(row, column, X.matrix()(row, column));
        actor->SetUserMatrix(matrix);
    }
};

} // namespace bask
