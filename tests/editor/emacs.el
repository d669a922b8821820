;;; emacs.el --- What tests/editor/emacs.sh runs inside of Emacs  -*- lexical-binding: t -*-

(require 'cl-lib)
(require 'povray-mode)

(defun check (holds form &rest objects)
  "Unless HOLDS, end with FORM, filled with OBJECTS."
  (unless holds
    (message "FAIL %s" (apply #'format form objects))
    (kill-emacs 1)))

(defun is (text face &optional nth)
  "Has the NTH place of TEXT this FACE from its beginning to its end?"
  (goto-char (point-min))
  (let ((case-fold-search nil))
    (check (search-forward text nil t (or nth 1)) "there is no `%s'" text))
  (dotimes (i (length text))
    (let ((found (get-text-property (+ (match-beginning 0) i) 'face)))
      (check (equal found face) "`%s' is %s, not %s" text found face))))

;; Colours.
(find-file "sample.pov")
(check (eq major-mode 'povray-mode) "sample.pov is %s" major-mode)
(font-lock-ensure)
(is "all of it" 'font-lock-comment-face)
(is "sphere in a comment" 'font-lock-comment-face)
(is "still a comment" 'font-lock-comment-face)
(is "#version" 'font-lock-preprocessor-face)
(is "#declare" 'font-lock-preprocessor-face)
(is "Size" 'font-lock-variable-name-face)
(is "#macro" 'font-lock-preprocessor-face)
(is "Ball" 'font-lock-function-name-face)
(is "Where" nil)
(is "sphere" 'font-lock-type-face 2)
(is "pigment" 'font-lock-keyword-face)
(is "rgb" 'font-lock-builtin-face)
(is "sin" 'font-lock-builtin-face)
(is "x" 'font-lock-constant-face 2)
(is "#for" 'font-lock-preprocessor-face)
(is "Index" 'font-lock-variable-name-face)
(is "a // text " 'font-lock-string-face)
(is " with /* in it" 'font-lock-string-face)
(is "union" 'font-lock-type-face)
(is "#unknown" nil)

;; Comments.
(goto-char (point-min))
(search-forward "union")
(comment-line 1)
(check (string-match-p "^// union" (buffer-string)) "comment-line: %s" (buffer-string))
(revert-buffer t t)

;; Indentation: lines come from nowhere to where they were.
(defun lines-that-move (file)
  "How many lines of FILE end elsewhere when all begin at the edge, and how many there are."
  (with-temp-buffer
    (insert-file-contents file)
    (povray-mode)
    (let ((before (split-string (buffer-string) "\n")) (moved 0))
      (goto-char (point-min))
      (while (not (eobp))
        (unless (nth 8 (save-excursion (syntax-ppss (line-beginning-position))))
          (delete-horizontal-space))
        (forward-line 1))
      (let ((inhibit-message t)) (indent-region (point-min) (point-max)))
      (let ((after (split-string (buffer-string) "\n")))
        (while before
          (unless (equal (string-trim-right (car before)) (car after))
            (setq moved (1+ moved))
            (when (getenv "TELL") (message "%s: %s\n    %s" file (car before) (car after))))
          (setq before (cdr before) after (cdr after)))
        (list moved (length after) (line-number-at-pos (point-max)))))))

(check (zerop (car (lines-that-move "sample.pov"))) "sample.pov is indented in another way")
(let ((moved 0) (all 0))
  (dolist (file (directory-files-recursively (getenv "SCENES") "\\.\\(?:scene\\|inc\\|pov\\)\\'"))
    (let ((counts (lines-that-move file)))
      (setq moved (+ moved (car counts)) all (+ all (nth 2 counts)))))
  (message "%d of %d lines of our scenes are indented in another way" moved all)
  ;; What goes on behind the end of its line stands where its author wants it.
  (check (< (* 50 moved) all) "more than one of fifty"))

;; What the language server's code lenses and keys ask for.
(let (asked)
  (cl-letf (((symbol-function 'compilation-start) (lambda (command &rest _) (push command asked))))
    (povray-render "/tmp/a b.pov")
    (let ((povray-durer-include '("/inc"))) (povray-watch "/tmp/a.pov")))
  (check (equal asked '("durer watch --open -I /inc /tmp/a.pov" "durer render /tmp/a\\ b.pov")) "%S" asked))

(defun wait-for (what holds)
  "Let programs talk until HOLDS gives something, or fail for want of WHAT."
  (let ((rounds 0))
    (while (and (not (funcall holds)) (< rounds 200))
      (accept-process-output nil 0.1)
      (setq rounds (1+ rounds)))
    (check (< rounds 200) "no %s" what)))

;; The language server, where there is eglot: it tells that `Unknown' is nothing.
(setq povray-durer-path (getenv "DURER"))
(when (require 'eglot nil t)
  (setq eglot-sync-connect 20)
  (call-interactively #'eglot)
  (flymake-mode 1)
  (wait-for "message" #'flymake-diagnostics)
  (check (seq-find (lambda (one) (string-match-p "`Unknown`" (flymake-diagnostic-text one))) (flymake-diagnostics))
         "%S" (flymake-diagnostics))
  ;; What its code lenses ask for.
  (let (asked (action '(:title "Render" :command "durer.render" :arguments ["/tmp/a.pov"])))
    (cl-letf (((symbol-function 'povray-render) (lambda (scene) (push scene asked))))
      (if (fboundp 'eglot-execute)
          (eglot-execute (eglot-current-server) action)
        (eglot-execute-command (eglot-current-server) "durer.render" ["/tmp/a.pov"])))
    (check (equal asked '("/tmp/a.pov")) "%S" asked))
  (eglot-shutdown (eglot-current-server))
  (message "eglot: ok"))

;; Something is drawn.
(with-temp-file "a small scene.pov" (insert "camera { location -3 * z } sphere { 0, 1 }"))
(povray--run '("render" "--size" "8x6") "a small scene.pov")
(wait-for "picture" (lambda () (file-exists-p "a small scene.png")))

;; INI files.
(find-file "sample.ini")
(check (eq major-mode 'povray-ini-mode) "sample.ini is %s" major-mode)
(font-lock-ensure)
(is "all of it" 'font-lock-comment-face)
(is "Input_File_Name" 'font-lock-variable-name-face)
(is "width" 'font-lock-variable-name-face)
(is "\"sample.pov\"" 'font-lock-string-face)
(is "[low]" 'font-lock-type-face)
(is "+A" 'font-lock-keyword-face)
(is "on" 'font-lock-constant-face 2)
(find-file "size.ini")
(check (eq major-mode 'povray-ini-mode) "size.ini is %s" major-mode)
(find-file "other.ini")
(check (not (eq major-mode 'povray-ini-mode)) "other.ini is %s" major-mode)

(message "ok")
;;; emacs.el ends here
