// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/icons.h"

#include <QLineEdit>

namespace mb {

/// A field that filters: leading icon, key badge while empty, "1 204 of 1 391 shown" at the right, Esc clears.
class SearchField : public QLineEdit {
    Q_OBJECT
public:
    SearchField(const ThemeSource &theme, const QString &placeholder, QWidget *parent = nullptr);
    /// Badge with the key that focuses this field ("Ctrl+F"). The shortcut itself belongs to the page.
    void setKeyHint(const QString &key);
    /// How much the filter leaves; empty hides it.
    void setResult(const QString &result);
    void setSymbol(Symbol symbol);
    QSize minimumSizeHint() const override;

protected:
    bool event(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;

private:
    void restyle();
    void updateMargins();
    [[nodiscard]] QString beside() const;

    const ThemeSource &m_theme;
    Symbol m_symbol = Symbol::Search;
    QString m_key;
    QString m_result;
};

} // namespace mb
