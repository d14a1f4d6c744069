// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QComboBox;
class QAbstractScrollArea;

namespace mb {

/// Names what Qt leaves without one when it is shown: on the bus a combo box is called as the text that is chosen in it, so its name goes
/// into its description, and to its list and its field; a page that scrolls is called as what is in it; forms of Qt's own (files) get
/// names for their lists. Install on the application. GUI thread.
class SpokenNames : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;
};

} // namespace mb
