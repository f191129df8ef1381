#pragma once
// What tells each object's temperature: the sensor on it, the thermal camera, or both.

#include "engine/model/experiment.h"

#include <QWidget>

#include <vector>

class QComboBox;
class QGridLayout;
class QLabel;

namespace bask {

/// Object names: "readBy.0" ..., "readByNote".
class ReadingPanel : public QWidget {
    Q_OBJECT

public:
    explicit ReadingPanel(QWidget* parent = nullptr);

    void setExperiment(const Experiment& experiment);
    void setEditable(bool editable);

signals:
    void chosen(std::size_t object, bask::ReadBy readBy);

protected:
    void changeEvent(QEvent* event) override;

private:
    struct Row {
        QLabel* name;
        QComboBox* readBy;
    };
    void addRow();
    void refresh();
    void retranslate();

    std::vector<std::string> m_names;
    std::vector<ReadBy> m_readBy;
    bool m_isPoseUnknown = false;
    QLabel *m_title, *m_note;
    QGridLayout* m_grid;
    std::vector<Row> m_rows;
};

} // namespace bask
