// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"

#include <QTextBrowser>
#include <QTimer>

namespace mb {

/// A page of the documentation, from the same Markdown that docs/ has, in the colours and the font of the program; its drawings too.
class HelpBrowser : public QTextBrowser {
    Q_OBJECT
public:
    HelpBrowser(const ThemeSource &theme, QWidget *parent = nullptr);

    /// "hardware/dmc60c", of the resources below :/help; false when there is no such page.
    bool showPage(const QString &topic);
    [[nodiscard]] const QString &topic() const { return m_topic; }

Q_SIGNALS:
    /// A link led to another page.
    void pageShown(const QString &topic);

protected:
    QVariant loadResource(int type, const QUrl &name) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    void follow(const QUrl &link);
    void fill();
    void refill();
    void dressTables();
    void dressCode();
    [[nodiscard]] QImage drawing(const QString &path) const;

    const ThemeSource &m_theme;
    QString m_topic;
    QTimer m_resized;
};

} // namespace mb
