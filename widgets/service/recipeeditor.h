// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"
#include "widgets/common/theme.h"

#include <QDialog>
#include <QPointer>

#include <optional>
#include <span>

class QLabel;
class QMessageBox;
class QPlainTextEdit;

namespace mb {

class CommandButton;
class RecipeForm;
struct Family;

/// A recipe is written: fields, beside them (below, where it is narrow) the file that they make, and its first mistake with its line, which is marked.
/// What has a mistake is not saved. Not modal: STOP works all the time. GUI thread.
class RecipeEditor : public QDialog {
    Q_OBJECT
public:
    /// A new recipe; it is first offered to be kept in `folder`, which is that of the project.
    RecipeEditor(
        std::span<const Family *const> families, const QString &folder, const ThemeSource &theme, QWidget *parent);

    /// The recipe of a file, which save() writes again; the error where it cannot be read.
    [[nodiscard]] Result<void> openFile(const QString &path);
    /// Into the file that was opened or chosen; asks for one where there is none yet. Nothing while there is a mistake.
    void save();
    /// False, and says why, when the recipe has a mistake there, or the file cannot be written.
    bool saveAs(const QString &path);
    [[nodiscard]] RecipeForm &form() { return *m_form; }
    /// What is wrong with the recipe, or why the file was not written, in words; empty: nothing.
    [[nodiscard]] QString problem() const;
    [[nodiscard]] bool canSave() const { return !m_problem; }
    /// Something is written here that no file has.
    [[nodiscard]] bool isUnsaved() const;
    /// Asks first where something would be lost.
    void reject() override;

Q_SIGNALS:
    void saved(const QString &path);

protected:
    void changeEvent(QEvent *event) override;

private:
    void buildBody();
    void buildFoot();
    void check();
    [[nodiscard]] bool isUntouched() const { return m_path.isEmpty() && !m_tried && !isUnsaved(); }
    void tell(const std::optional<Error> &problem);
    void mark();
    void speak(const std::optional<Error> &problem);
    [[nodiscard]] std::optional<Error> mistakeIn(const QByteArray &text, const QString &folder) const;
    [[nodiscard]] QString folder() const;
    void ask();
    void askToDiscard();

    std::span<const Family *const> m_families;
    const ThemeSource &m_theme;
    QString m_folder;
    QString m_path;       ///< empty: of no file yet
    QByteArray m_kept;    ///< as it was opened or saved last
    bool m_tried = false; ///< to save it
    std::optional<Error> m_problem;
    RecipeForm *m_form = nullptr;
    QPlainTextEdit *m_text = nullptr;
    QLabel *m_words = nullptr;
    CommandButton *m_save = nullptr;
    QPointer<QMessageBox> m_question;
};

} // namespace mb
