;;; povray-mode.el --- POV-Ray's scene language, with durer  -*- lexical-binding: t -*-

;; Version: 0.1.0
;; Package-Requires: ((emacs "27.1"))
;; Keywords: languages

;;; Commentary:
;; Colours, indentation, and `durer lsp' by way of eglot.

;;; Code:

(require 'povray-words)

(defgroup povray nil
  "POV-Ray's scene language."
  :group 'languages)

(defcustom povray-durer-path "durer"
  "The program."
  :type 'string)

(defcustom povray-durer-include nil
  "Folders in which include files are looked for too."
  :type '(repeat directory))

(defcustom povray-indent 2
  "Blanks for each level."
  :type 'integer
  :safe #'integerp)

;;;; Colours

(defvar povray-mode-syntax-table
  (let ((table (make-syntax-table)))
    (modify-syntax-entry ?_ "w" table)
    (modify-syntax-entry ?\" "\"" table)
    (modify-syntax-entry ?\\ "\\" table)
    (modify-syntax-entry ?# "." table)
    (dolist (sign '(?< ?> ?= ?+ ?- ?& ?| ?! ?% ?$ ?'))
      (modify-syntax-entry sign "." table))
    ;; Comments between /* and */ nest; those of // end with their line.
    (modify-syntax-entry ?/ ". 124" table)
    (modify-syntax-entry ?* ". 23bn" table)
    (modify-syntax-entry ?\n ">" table)
    (modify-syntax-entry ?\r ">" table)
    table)
  "What characters are in scenes.")

(defvar povray-font-lock-keywords
  (let ((any (lambda (words) (regexp-opt words 'words)))
        (name "\\([A-Za-z_][A-Za-z0-9_]*\\)"))
    `((,(concat "#[ \t]*macro[ \t\n]+" name) 1 font-lock-function-name-face)
      (,(concat "#[ \t]*\\(?:declare\\|local\\)[ \t\n]+" name) 1 font-lock-variable-name-face)
      (,(concat "#[ \t]*for[ \t]*([ \t]*" name) 1 font-lock-variable-name-face)
      (,(concat "#[ \t]*" (funcall any povray-words-directives)) 0 font-lock-preprocessor-face)
      (,(funcall any povray-words-objects) 0 font-lock-type-face)
      (,(funcall any povray-words-blocks) 0 font-lock-keyword-face)
      (,(funcall any povray-words-functions) 0 font-lock-builtin-face)
      (,(funcall any povray-words-constants) 0 font-lock-constant-face)
      (,(funcall any povray-words-others) 0 font-lock-builtin-face)))
  "What is coloured in scenes.")

;;;; Indentation

(defun povray--directive-regexp (words)
  "What finds a line that begins with one of the directives WORDS."
  (concat "[ \t]*#[ \t]*" (regexp-opt words 'words)))

(defconst povray--opens (povray--directive-regexp povray-words-openers))
(defconst povray--continues (povray--directive-regexp povray-words-continuers))
(defconst povray--ends (povray--directive-regexp (cons "end" povray-words-continuers)))
(defconst povray--end (povray--directive-regexp '("end")))
(defconst povray--switch (povray--directive-regexp '("switch")))

(defun povray--stays-open-p ()
  "Does this line begin with a directive whose #end stands further down?"
  (save-excursion
    (let ((depth (if (looking-at povray--opens) 0 -1000))
          (end (line-end-position)))
      (while (re-search-forward "#[ \t]*\\([a-z]+\\)\\>" end t)
        (let ((word (match-string 1)))
          (unless (nth 8 (save-excursion (syntax-ppss (match-beginning 0))))
            (cond ((member word povray-words-openers) (setq depth (1+ depth)))
                  ((equal word "end") (setq depth (1- depth)))))))
      (> depth 0))))

(defun povray--sibling (bracket)
  "Go to the line before this one with the same BRACKET around its beginning.
Return nil if there is none."
  (let (found)
    (while (and (not found) (zerop (forward-line -1)) (or (null bracket) (> (point) bracket)))
      (let* ((state (save-excursion (syntax-ppss (point))))
             (open (nth 1 state)))
        (cond ((nth 8 state) (goto-char (nth 8 state)) (forward-line 0) (forward-line 1))
              ((looking-at "[ \t]*\\(?:$\\|//\\)"))
              ((eql open bracket) (setq found t))
              ;; All of the inner brackets at once.
              (open (goto-char open) (forward-line 0) (forward-line 1)))))
    found))

(defun povray--opener-column (bracket)
  "Where an #end or #else here should begin, with BRACKET around it."
  (save-excursion
    (let ((within (if (looking-at povray--continues) povray-indent 0))
          (depth 0)
          column)
      (while (and (not column) (povray--sibling bracket))
        (cond ((looking-at povray--end) (setq depth (1+ depth)))
              ((not (povray--stays-open-p)))
              ((> depth 0) (setq depth (1- depth)))
              ;; What belongs to a #switch stands one level further in.
              (t (setq column (+ (current-indentation) (if (looking-at povray--switch) within 0))))))
      column)))

(defun povray--column ()
  "Where this line should begin."
  (save-excursion
    (forward-line 0)
    (let* ((state (save-excursion (syntax-ppss (point))))
           (bracket (nth 1 state))
           (base (if bracket
                     (save-excursion (goto-char bracket) (+ (current-indentation) povray-indent))
                   0)))
      (cond
       ((nth 8 state) (current-indentation))
       ((and bracket (looking-at "[ \t]*[])}]")) (- base povray-indent))
       ((looking-at povray--ends) (or (povray--opener-column bracket) base))
       ((povray--sibling bracket)
        (+ (current-indentation)
           (if (or (looking-at povray--continues) (povray--stays-open-p)) povray-indent 0)))
       (t base)))))

(defun povray-indent-line ()
  "Put this line where brackets and directives around it want it."
  (interactive)
  (let ((column (povray--column)))
    (if (<= (current-column) (current-indentation))
        (indent-line-to column)
      (save-excursion (indent-line-to column)))))

;;;; Drawing

(defun povray--run (words &optional scene)
  "Run durer with WORDS and the file SCENE, or this one, in a buffer of its own."
  (let* ((file (expand-file-name (or scene buffer-file-name (user-error "This text has no file yet"))))
         (default-directory (file-name-directory file))
         (include (mapcan (lambda (folder) (list "-I" (expand-file-name folder))) povray-durer-include)))
    (save-some-buffers nil (lambda () (equal buffer-file-name file)))
    (compilation-start (mapconcat #'shell-quote-argument
                                  (append (list povray-durer-path) words include (list file)) " ")
                       nil (lambda (_) (format "*durer %s*" (car words))))))

(defun povray-render (&optional scene)
  "Draw the file SCENE, or this one."
  (interactive)
  (povray--run '("render") scene))

(defun povray-watch (&optional scene)
  "Show the file SCENE, or this one, in the browser, again whenever it is saved."
  (interactive)
  (povray--run '("watch" "--open") scene))

;;;; The modes

(defvar povray-mode-map
  (let ((map (make-sparse-keymap)))
    (define-key map (kbd "C-c C-c") #'povray-render)
    (define-key map (kbd "C-c C-w") #'povray-watch)
    map)
  "Keys in scenes.")

;;;###autoload
(define-derived-mode povray-mode prog-mode "POV"
  "Scenes of POV-Ray and durer."
  (setq-local comment-start "// ")
  (setq-local comment-end "")
  (setq-local comment-start-skip "\\(?://+\\|/\\*+\\)[ \t]*")
  (setq-local indent-tabs-mode nil)
  (setq-local indent-line-function #'povray-indent-line)
  (setq-local electric-indent-chars (append "}])" electric-indent-chars))
  (setq-local font-lock-defaults '(povray-font-lock-keywords)))

(defvar povray-ini-font-lock-keywords
  `((,(concat "^[ \t]*\\(" (regexp-opt povray-words-options) "\\)[ \t]*=") 1 font-lock-variable-name-face)
    ("^[ \t]*\\[[^]\n]*\\]?" 0 font-lock-type-face)
    ("\\(?:^\\|[ \t]\\)\\([-+][A-Za-z]+\\)" 1 font-lock-keyword-face)
    (,(regexp-opt '("on" "off" "true" "false" "yes" "no") 'words) 0 font-lock-constant-face))
  "What is coloured in INI files.")

(defvar povray-ini-mode-syntax-table
  (let ((table (make-syntax-table)))
    (modify-syntax-entry ?_ "w" table)
    (modify-syntax-entry ?\" "\"" table)
    (modify-syntax-entry ?\; "<" table)
    (modify-syntax-entry ?# "<" table)
    (modify-syntax-entry ?\n ">" table)
    table)
  "What characters are in INI files.")

;;;###autoload
(define-derived-mode povray-ini-mode prog-mode "POV-INI"
  "INI files of POV-Ray and durer."
  (setq-local comment-start "; ")
  (setq-local font-lock-defaults '(povray-ini-font-lock-keywords nil t)))

(defun povray-ini-file-p ()
  "Is this one of POV-Ray's INI files?
In those a switch stands, or an option that can only be POV-Ray's (Width
others have too), or several settings, all of which are options."
  (and buffer-file-name
       (string-match-p "\\.ini\\'" buffer-file-name)
       (save-excursion
         (let ((known (mapcar #'downcase povray-words-options))
               (settings 0) (ours 0) sure)
           (while (and (not sure)
                       (re-search-forward "^[ \t]*\\(?:\\([A-Za-z0-9_]+\\)[ \t]*=\\|[-+][WHI][^ \t\n]\\)" nil t))
             (let ((name (match-string 1)))
               (cond ((null name) (setq sure t))
                     ((not (member (downcase name) known)) (setq settings (1+ settings)))
                     ((string-match-p "_" name) (setq sure t))
                     (t (setq settings (1+ settings) ours (1+ ours))))))
           (or sure (and (> ours 1) (= ours settings)))))))

;;;###autoload
(add-to-list 'auto-mode-alist '("\\.\\(?:pov\\|inc\\|scene\\)\\'" . povray-mode))
;;;###autoload
(add-to-list 'magic-mode-alist '(povray-ini-file-p . povray-ini-mode))

;;;; The language server

(defun povray-server (&rest _)
  "How the language server is started."
  (append (list povray-durer-path "lsp")
          (mapcan (lambda (folder) (list "-I" (expand-file-name folder))) povray-durer-include)))

(defun povray--carry-out (command arguments)
  "Carry out COMMAND of a code lens with ARGUMENTS.
Return nil if it is none of ours."
  (let ((scene (and arguments (elt arguments 0))))
    (pcase (format "%s" command)
      ("durer.render" (povray-render scene) t)
      ("durer.watch" (povray-watch scene) t))))

(defun povray--eglot-execute (_server action)
  "Carry out ACTION, a command or what holds one."
  (let ((command (plist-get action :command)))
    (if (listp command)
        (povray--carry-out (plist-get command :command) (plist-get command :arguments))
      (povray--carry-out command (plist-get action :arguments)))))

(defvar eglot-server-programs)
(with-eval-after-load 'eglot
  (add-to-list 'eglot-server-programs (cons 'povray-mode #'povray-server))
  ;; The latter is of newer versions.
  (advice-add 'eglot-execute-command :before-until
              (lambda (_server command arguments) (povray--carry-out command arguments)))
  (advice-add 'eglot-execute :before-until #'povray--eglot-execute))

(declare-function lsp-register-client "lsp-mode")
(declare-function make-lsp-client "lsp-mode")
(declare-function lsp-stdio-connection "lsp-mode")
(declare-function lsp-activate-on "lsp-mode")
(defun povray--lsp-handler (command)
  "What carries out COMMAND for lsp-mode."
  (lambda (action)
    ;; Which of both it is, was chosen when lsp-mode was compiled.
    (povray--carry-out command (if (hash-table-p action)
                                   (gethash "arguments" action)
                                 (plist-get action :arguments)))))

(defvar lsp-language-id-configuration)
(with-eval-after-load 'lsp-mode
  (add-to-list 'lsp-language-id-configuration '(povray-mode . "povray"))
  (let ((handlers (make-hash-table :test 'equal)))
    (dolist (command '("durer.render" "durer.watch"))
      (puthash command (povray--lsp-handler command) handlers))
    (lsp-register-client
     (make-lsp-client :new-connection (lsp-stdio-connection #'povray-server)
                      :activation-fn (lsp-activate-on "povray")
                      :action-handlers handlers
                      :server-id 'durer))))

(provide 'povray-mode)
;;; povray-mode.el ends here
