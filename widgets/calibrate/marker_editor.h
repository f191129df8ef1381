#pragma once
// The markers of a rig: the part of each, its id, side and pose, and whether the camera sees it.

#include "engine/model/vision_spec.h"
#include "engine/vision/vision_view.h"

#include <QWidget>

#include <array>

class QComboBox;
class QDoubleSpinBox;
class QGridLayout;
class QLabel;
class QPushButton;
class QTreeWidget;

namespace bask {

class WholeNumberField;

/// Emits a whole new value per committed edit. Object names: "markerDictionary", "markerList", "markerAdd",
/// "markerRemove", "markerPart", "markerId", "markerSide", "marker.x" ... "marker.theta_z".
class MarkerEditor : public QWidget {
    Q_OBJECT

public:
    explicit MarkerEditor(QWidget* parent = nullptr);

    void setVision(const VisionSpec& vision);
    void setView(const VisionView& view); ///< shows which markers are seen

signals:
    void visionEdited(const bask::VisionSpec& vision);

protected:
    void changeEvent(QEvent* event) override;

private:
    void buildForm(QGridLayout* form);
    QDoubleSpinBox* number(const QString& name);
    int selected() const;
    void edit(const std::function<void(MarkerSpec&)>& change);
    void add();
    void remove();
    void showList();
    void showForm();
    void showSeen();
    void retranslate();
    int freeId() const; ///< a seen id that is not listed, otherwise the lowest free one

    VisionSpec m_vision;
    std::vector<ViewedMarker> m_seen;
    bool m_showing = false;
    QLabel* m_dictionaryLabel;
    QComboBox* m_dictionary;
    QTreeWidget* m_list;
    QPushButton* m_add;
    QPushButton* m_remove;
    QComboBox* m_part;
    WholeNumberField* m_id;
    QDoubleSpinBox* m_side;
    std::array<QDoubleSpinBox*, 6> m_pose{};
    std::array<QLabel*, 9> m_captions{};
};

} // namespace bask
