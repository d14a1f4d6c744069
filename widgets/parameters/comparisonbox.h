// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/selection.h"
#include "widgets/common/workbench.h"
#include "widgets/parameters/parametermodel.h"

#include <QWidget>

#include <map>

class QComboBox;
class QMenu;

namespace mb {

/// What the values are compared with: the defaults, what the device had when it was found, a file, another axis. Sets the
/// reference of the model.
class ComparisonBox : public QWidget {
    Q_OBJECT
public:
    ComparisonBox(Workbench &workbench, Selection &selection, ParameterModel &model, QWidget *parent);

    /// Keeps the first complete values of every device as those that it was found with.
    void remember(const DeviceView &device);
    void compareWith(ParameterReference file);
    /// The model shows something else.
    void forgetFile();
    /// The axis that is shown is another one: its neighbour is no measure for it.
    void forgetAxis();
    /// What can be chosen, and what is.
    void refresh();
    /// The same choice, below a title.
    void addTo(QMenu &menu);

Q_SIGNALS:
    void fileRequested();

private:
    using References = std::map<DeviceId, ParameterReference>;
    void choose(int row);

    Workbench &m_workbench;
    Selection &m_selection;
    ParameterModel &m_model;
    QComboBox *m_box = nullptr;
    References &m_asFound{m_workbench.kept<References>()};
    std::optional<ParameterReference> m_file;
    int m_axis = 0; ///< that the values are compared with
};

} // namespace mb
