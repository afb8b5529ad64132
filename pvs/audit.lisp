;; What the proofs in some theories rest on besides proof: asked of PVS itself, after it has read and
;; type-checked them, so that no trick of spelling hides anything.  pvs/check loads prover.lisp and this file.
;;
;; (starl-audit FILE LIBRARY), FILE without .pvs, LIBRARY the folder of the library's theories, prints a
;; line each, `starl: KIND WORDS`:
;;   theory FILE NAME          each theory of the file, and each that these rest on
;;   axiom THEORY NAME         taken for true without a proof
;;   undischarged THEORY NAME  an assumption of a theory that none uses but those that assume something, too
;;   empty THEORY NAME         a value parameter whose type may have no values, of a theory that no theory
;;                             without parameters uses: its theorems may be about nothing
;;   outside THEORY NAME       rests on a theory of another folder, which nothing here checks
;;   redefined THEORY NAME OF  a theory that is not the library's has a name of the theory OF, the library's or
;;                             PVS's, for something of its own that can be taken for it
;;   conversion THEORY NAME    a theory that is not the library's has a CONVERSION: formulas say what they do not show
;;   hollow THEORY NAME        it uses the automaton NAME of the library with a type that may have no values
;;   mixed THEORY OF           it uses time_machine with the states of OF, and not with its steps
;;   foreign THEORY NAME       a name that is not ASCII: it may look like another one
;;   narrow THEORY LINE        a function with values of a smaller type than its place has: the prover is
;;                             wrong about later updates of that place (docs/proofs.md)
(in-package :pvs)

(defun starl-line (kind theory what)
  (format t "~&starl: ~a ~a ~a~%" kind (id theory) what))

(defun starl-in-library? (th library)
  (probe-file (format nil "~a/~a.pvs" library (filename th))))

(defun starl-own (theories)
  "Those of THEORIES that are files of this folder, not of PVS."
  (remove-if-not #'(lambda (th)
                     (and (module? th)
                          (filename th)
                          (null (generated-by th))
                          (probe-file (format nil "~a.pvs" (filename th)))))
                 theories))

(defun starl-declarations (th)
  (remove-if-not #'declaration? (append (assuming th) (theory th))))

(defun starl-outside (th)
  ;; PVS's own folder `lib' is trusted as the prelude is.
  (dolist (use (all-usings th))
    (let ((used (car use)))
      (unless (or (from-prelude? used)
                  (null (filename used))
                  (search (format nil "~alib/" (truename *pvs-path*)) (namestring (truename (context-path used))))
                  (equal (truename (context-path used)) (truename (context-path th))))
        (starl-line "outside" th (id used))))))

(defun starl-axioms (th)
  (dolist (d (starl-declarations th))
    (when (and (formula-decl? d)
               (not (tcc-decl? d))
               (null (generated-by d)) ; those of data types and inductive definitions are PVS's own
               (or (member (spelling d) '(axiom postulate))
                   (and (eq (spelling d) 'assumption) (memq d (theory th)))))
      (starl-line "axiom" th (id d)))))

(defun starl-used? (th by)
  "Whether BY, or what it uses, uses TH with actual parameters."
  (some #'(lambda (use) (and (eq (id (car use)) (id th)) (some #'actuals (cdr use)))) (all-usings by)))

(defun starl-assumptions (th all)
  ;; PVS makes each use of a theory with assumptions prove them; a theory that assumes something itself
  ;; may prove them by that.
  (unless (some #'(lambda (user) (and (null (assuming user)) (starl-used? th user))) all)
    (dolist (d (assuming th))
      (when (formula-decl? d)
        (starl-line "undischarged" th (id d))))))

(defvar *starl-within* nil "The data types whose values are being asked for.")

(defun starl-may-be-empty? (type)
  "Whether TYPE, or what its functions, records, tuples and forms are made of, is a subtype: but for PVS's own
without parameters, it is not known to have a value. PVS takes the type of a parameter for one that has."
  (typecase type
    (type-name
     (and (adt? type)
          (or (member type *starl-within* :test #'tc-eq)
              (let ((*starl-within* (cons type *starl-within*)))
                (every #'(lambda (form)
                           (some #'(lambda (part) (starl-may-be-empty? (range (type part)))) (accessors form)))
                       (constructors type))))))
    (dep-binding (starl-may-be-empty? (type type)))
    (subtype (or (not (starl-named-in-prelude? type))
                 (actuals (module-instance (resolution (print-type type))))))
    (funtype (starl-may-be-empty? (range type)))
    (recordtype (some #'(lambda (field) (starl-may-be-empty? (type field))) (fields type)))
    (tupletype (some #'starl-may-be-empty? (types type)))
    (cotupletype (every #'starl-may-be-empty? (types type)))))

(defun starl-parameters (th all)
  (dolist (declared (starl-declarations th))
    (dolist (d (decl-formals declared))
      (when (and (formal-const-decl? d) (starl-may-be-empty? (type d)))
        (starl-line "empty" th (id d)))))
  (dolist (d (formals th))
    (when (and (formal-const-decl? d)
               (starl-may-be-empty? (type d))
               (notany #'(lambda (user) (and (null (formals user)) (starl-used? th user))) all))
      (starl-line "empty" th (id d)))))

(defun starl-narrower? (has wanted)
  "Whether type HAS has, somewhere inside, functions with values of a smaller type than WANTED has there."
  (let ((has (find-supertype has))
        (wanted (find-supertype wanted)))
    (cond ((and (funtype? has) (funtype? wanted))
           (or (and (subtype? (range has))
                    ;; Of these (posnat, finite_set) the prover does not conclude what the values are; tried.
                    (not (starl-named-in-prelude? (range has)))
                    (not (tc-eq (range has) (range wanted)))
                    (subtype-of? (range has) (range wanted)))
               (starl-narrower? (range has) (range wanted))))
          ((and (recordtype? has) (recordtype? wanted))
           (loop for field in (fields wanted)
                 for same = (find (id field) (fields has) :key #'id)
                 thereis (and same (starl-narrower? (type same) (type field)))))
          ((and (tupletype? has) (tupletype? wanted))
           (loop for a in (types has)
                 for b in (types wanted)
                 thereis (starl-narrower? (starl-type a) (starl-type b)))))))

(defun starl-type (type)
  (if (dep-binding? type) (type type) type))

(defun starl-structured? (type)
  (let ((top (find-supertype type)))
    (or (funtype? top) (recordtype? top) (tupletype? top))))

(defun starl-places (ex)
  "The expressions within EX that give something of a declared type its value, each with that type."
  (cond ((or (record-expr? ex) (update-expr? ex))
         (let ((record (find-supertype (type ex))))
           (when (recordtype? record)
             (loop for each in (assignments ex)
                   for name = (caar (arguments each))
                   for field = (and (null (cdr (arguments each)))
                                    (find (id name) (fields record) :key #'id))
                   when field collect (cons (expression each) (type field))))))
        ((and (application? ex) (not (let-expr? ex)) (not (equation? ex)) (not (disequation? ex)))
         ;; What gives no function or record back cannot pass it on.
         (let ((domain (and (starl-structured? (type ex)) (domain (find-supertype (type (operator ex)))))))
           (if (or (null domain) (cdr (arguments ex)))
               (let ((types (and domain (tupletype? (find-supertype domain)) (types (find-supertype domain)))))
                 (when (= (length types) (length (arguments ex)))
                   (mapcar #'cons (arguments ex) types)))
               (list (cons (argument ex) domain)))))))

(defun starl-narrow (th)
  (flet ((tell (ex at)
           (starl-line "narrow" th (elt (or (place ex) (place at) #("?")) 0))))
    (mapobject #'(lambda (ex)
                   (when (expr? ex)
                     (loop for (value . wanted) in (starl-places ex)
                           when (starl-narrower? (type value) (starl-type wanted))
                             do (tell value ex)))
                   nil)
               (append (assuming th) (theory th)))
    (dolist (d (starl-declarations th))
      (when (and (const-decl? d) (null (generated-by d)) (null (formals d)) (definition d)
                 (starl-narrower? (type (definition d)) (type d)))
        (tell (definition d) d)))))

(defun starl-alike? (own its)
  "Whether a value of type OWN can be taken for one of type ITS, of a library's theory, by its type."
  (let ((own (find-supertype (starl-type own)))
        (its (find-supertype (starl-type its))))
    (cond ((type-name? its)
           (let ((d (declaration its)))
             (or (formal-type-decl? d) ; it may be any type
                 (and (type-name? own) (eq (declaration own) d))
                 (and (type-name? own) (tc-eq own its)))))
          ((and (funtype? own) (funtype? its))
           (and (starl-alike? (domain own) (domain its)) (starl-alike? (range own) (range its))))
          ((and (recordtype? own) (recordtype? its))
           (null (set-exclusive-or (mapcar #'id (fields own)) (mapcar #'id (fields its)))))
          ((and (tupletype? own) (tupletype? its))
           (and (= (length (types own)) (length (types its)))
                (every #'starl-alike? (types own) (types its)))))))

(defun starl-redefines? (own its)
  "Whether declaration OWN can be taken for ITS. An automaton of its own has states and actions, too."
  (and (eq (id own) (id its))
       (cond ((and (typep own '(or const-decl var-decl formal-const-decl bind-decl)) (const-decl? its))
              (starl-alike? (type own) (type its)))
             ((and (type-decl? own) (type-decl? its))
              (or (not (member (id own) '(|states| |actions|)))
                  (starl-alike? (type-value own) (type-value its)))))))

(defun starl-bound (th)
  "The bound variables within TH."
  (let ((all nil))
    (mapobject #'(lambda (ex)
                   (when (binding-expr? ex) (setf all (append (bindings ex) all)))
                   nil)
               (append (assuming th) (theory th)))
    all))

(defun starl-redefined (th of)
  (dolist (own (append (formals th) (starl-declarations th) (starl-bound th)))
    (when (and (or (typep own 'bind-decl)
                   (null (generated-by own))
                   ;; Forms of a data type; PVS's own names for parts of any type are no trick.
                   (and (typep own '(or adt-constructor-decl adt-recognizer-decl adt-accessor-decl))
                        (not (from-prelude? of))))
               (some #'(lambda (its) (and (declaration? its) (starl-redefines? own its))) (theory of)))
      (starl-line "redefined" th (format nil "~a ~a" (id own) (id of))))))

(defun starl-home (ex)
  "The theory that declares the name EX, of a type or a value."
  (let ((name (if (type-expr? ex) (or (print-type ex) ex) ex)))
    (and (name? name) (resolution name) (module (declaration name)))))

(defun starl-instances (th library)
  (dolist (use (all-usings th))
    (when (and (filename (car use)) (starl-in-library? (car use) library))
      (dolist (actuals (remove nil (mapcar #'actuals (cdr use))))
        ;; The states of an automaton, the file's own too, are made of what it declares.
        (when (and (find '|states| (starl-declarations (car use)) :key #'id)
                   (some #'(lambda (a) (and (type-value a) (starl-may-be-empty? (type-value a)))) actuals))
          (starl-line "hollow" th (id (car use))))
        (when (eq (id (car use)) '|time_machine|)
          (let ((home (starl-home (type-value (car actuals)))))
            (when (and home
                       (starl-in-library? home library)
                       (notevery #'(lambda (a) (eq (starl-home (or (type-value a) (expr a))) home)) actuals))
              (starl-line "mixed" th (id home)))))))))

(defun starl-foreign (th)
  (dolist (d (append (formals th) (starl-declarations th)))
    (when (notevery #'(lambda (c) (< (char-code c) 128)) (string (id d)))
      (starl-line "foreign" th (id d)))))

(defun starl-audit (file library)
  (let* ((all (starl-own (imported-theories-in-theories (theories-in-file file)))))
    (dolist (th all)
      (starl-line "theory" th (filename th)))
    (dolist (th all)
      (let ((*current-context* (context th)))
        (starl-outside th)
        (starl-axioms th)
        (starl-assumptions th all)
        (starl-parameters th all)
        (starl-narrow th)
        (unless (starl-in-library? th library)
          (starl-foreign th)
          (starl-instances th library)
          (dolist (d (starl-declarations th))
            (when (typep d 'conversion-decl) (starl-line "conversion" th "-"))
            (when (and (typep d 'theory-reference) (probe-file (format nil "~a/~a.pvs" library (id d))))
              (starl-line "redefined" th (format nil "~a ~a" (id d) (id d)))))
          (dolist (of (append all *prelude-theories*))
            (when (or (from-prelude? of) (starl-in-library? of library))
              (starl-redefined th of))))))
    (starl-line "audited" (car all) (length all))))
