;; Mends an error of the prover (docs/proofs.md).  PVS loads this file before it proves: pvs/check puts it in
;; its folder as `pvs-strategies`.
;;
;; To set one value of a function whose values are all of a smaller type, PVS gives the changed function the
;; smaller type, too, and then takes the new value for one of that type.  Here it gets the larger type.
(in-package :pvs)

(defun starl-named-in-prelude? (type)
  (let ((name (print-type type)))
    (and (type-name? name)
         (resolution name)
         (let ((th (module (declaration name))))
           (and (typep th 'module) (from-prelude? th))))))

(defun starl-wide (type)
  "TYPE with larger types of its values; numbers stay what they are."
  (cond ((and (subtype? type) (not (starl-named-in-prelude? type))) (starl-wide (supertype type)))
        ((funtype? type)
         (let ((range (starl-wide (range type))))
           (if (eq range (range type)) type (lcopy type 'range range 'print-type nil))))
        (t type)))

(defun make!-update-expr (expression assignments)
  (make-instance 'update-expr
    :expression expression
    :assignments assignments
    :type (starl-wide (if (some #'(lambda (ass) (typep ass 'maplet)) assignments)
                          (find-update-commontype (type expression) expression assignments)
                          (find-supertype (type expression))))))
