/**
 * Bugs planted one at a time in loaded classes, to see whether runs find them. PIT makes them in the bytecode: a condition negated or
 * its boundary moved, a call removed, an operator replaced, another constant returned. A second process redefines one class after the
 * other, so that its compiled code stays; a bug that never ends costs that process, and not this one.
 *
 * <p>May import: core, PIT, ASM; no other part of the command line.
 */
@NullMarked
package org.starl.cli.mutants;

import org.jspecify.annotations.NullMarked;
