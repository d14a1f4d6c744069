// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"

#include <QStringList>
#include <QWidget>

namespace mb {

/// The indigo stripe under the header: simulated and replayed data can never pass as real.
class DemoStripe : public QWidget {
    Q_OBJECT
public:
    explicit DemoStripe(const ThemeSource &theme, QWidget *parent = nullptr);
    /// "simulated bench, seed 7", empty without one, and the recordings that are open; the stripe adds the rest.
    void setSources(const QString &simulated, const QStringList &recordings);
    /// Nothing simulated, nothing replayed: nothing is painted, and the place stays.
    bool isEmpty() const { return m_text.isEmpty(); }
    /// One word, where a notice needs the room.
    void setCompact(bool compact);
    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    const ThemeSource &m_theme;
    QString m_text;
    QString m_word;
    bool m_compact = false;
};

} // namespace mb
