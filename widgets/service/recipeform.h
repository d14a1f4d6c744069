// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"

#include <QWidget>

#include <span>
#include <vector>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QGroupBox;
class QLabel;
class QLineEdit;
class QTableWidget;
class QVBoxLayout;

namespace mb {

struct Family;

/// A recipe in fields: name, family, firmware, parameters, number rule, self-test with its limits and what it accepts. It takes whatever
/// is typed, as it is typed: what is wrong with it is found in text(). GUI thread.
class RecipeForm : public QWidget {
    Q_OBJECT
public:
    RecipeForm(std::span<const Family *const> families, const ThemeSource &theme, QWidget *parent);

    /// Of a recipe without mistakes.
    void setText(const QByteArray &recipe);
    /// The text of its file; an empty field is a key that is not there.
    [[nodiscard]] QByteArray text() const;
    /// Files are named relative to it where they lie in it.
    void setFolder(const QString &folder) { m_folder = folder; }

Q_SIGNALS:
    void changed();

private:
    enum class Kind { Text, File, Number };
    struct Field {
        QString path; ///< "test.limits.travel"
        Kind kind;
        QLineEdit *edit;
        QLabel *label;
    };
    [[nodiscard]] QFormLayout &newForm(QWidget *parent) const;
    void buildUnit(QVBoxLayout &column);
    [[nodiscard]] QWidget *buildTest();
    [[nodiscard]] QWidget *buildAccept(QWidget *parent);
    void add(QFormLayout &form, const QString &label, const char *path, Kind kind);
    void browse(QLineEdit &edit);
    void followFamily();
    void followLoop();
    [[nodiscard]] const Family *family() const;
    [[nodiscard]] bool isYesOrNo(int row) const;
    [[nodiscard]] QJsonValue accepted(int row) const;
    void accept(int row, const QJsonValue &value);

    std::span<const Family *const> m_families;
    const ThemeSource &m_theme;
    QString m_folder;
    std::vector<Field> m_fields;
    QComboBox *m_family = nullptr;
    QCheckBox *m_store = nullptr;
    QGroupBox *m_test = nullptr;
    QComboBox *m_loop = nullptr;
    QTableWidget *m_accept = nullptr;
};

} // namespace mb
