package org.starl.lang.read;

import java.util.List;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Primitive;
import org.starl.lang.tree.Program;

/**
 * What was read of a text, also of a wrong one.
 *
 * @param automata without meaning if there are errors; each program has one, of the same name
 * @param programs without meaning if there are errors
 * @param primitives without meaning if there are errors
 * @param errors in the order of the text
 * @param references the names whose meaning is known, in the order in which they were read
 */
public record Source(
    List<Automaton> automata,
    List<Program> programs,
    List<Primitive> primitives,
    List<SourceError> errors,
    List<Reference> references) {

  static final Source EMPTY = new Source(List.of(), List.of(), List.of(), List.of(), List.of());
}
