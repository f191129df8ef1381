#pragma once
// Profiles of devices in a list to choose from.

#include <QComboBox>
#include <QString>

#include <algorithm>
#include <vector>

namespace bask {

/// Lists a profile, unless it is listed, and chooses it; `listed` are those of the box.
template <class Profile>
void listAndChoose(QComboBox& box, std::vector<Profile>& listed, const Profile& profile) {
    const auto it = std::ranges::find(listed, profile);
    const auto index = static_cast<int>(it - listed.begin());
    if (it == listed.end()) {
        listed.push_back(profile);
        box.addItem(QString::fromStdString(profile.title.empty() ? profile.name : profile.title));
        box.setItemData(index, QString::fromStdString(profile.source), Qt::ToolTipRole);
    }
    box.setCurrentIndex(index);
}

} // namespace bask
