// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"

#include <QTextBrowser>
#include <QTimer>

namespace mb {

/// A page of the documentation, from the same Markdown that docs/ has, in the language, the colours and the font of the program; its
/// drawings too. Follows a change of each.
class HelpBrowser : public QTextBrowser {
    Q_OBJECT
public:
    HelpBrowser(const ThemeSource &theme, QWidget *parent = nullptr);

    /// "hardware/dmc60c", of the resources below :/help, in English where the language of the window has none; false when there is no
    /// such page.
    bool showPage(const QString &topic);
    [[nodiscard]] QString topic() const;
    /// The file that is shown: ":/help/de/tuning.md". In English where nobody has translated the page.
    [[nodiscard]] const QString &file() const { return m_file; }

Q_SIGNALS:
    /// A link led to another page.
    void pageShown(const QString &topic);

protected:
    QVariant loadResource(int type, const QUrl &name) override;
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    void open(const QString &file);
    void follow(const QUrl &link);
    void goToHeading(const QString &anchor);
    void fill();
    void refill();
    void dressTables(QTextDocument &page) const;
    static void dressCode(QTextDocument &page);
    [[nodiscard]] double room() const;
    [[nodiscard]] QImage drawing(const QString &path) const;
    [[nodiscard]] QImage picture(const QString &path) const;

    const ThemeSource &m_theme;
    QString m_file; ///< empty: none yet
    QTimer m_resized;
};

} // namespace mb
