package org.starl.lang.read;

import java.util.List;
import org.starl.lang.tree.Automaton;

/**
 * What was read of a text, also of a wrong one.
 *
 * @param automata without meaning if there are errors
 * @param errors in the order of the text
 * @param references the names whose meaning is known, in the order in which they were read
 */
public record Source(
    List<Automaton> automata, List<SourceError> errors, List<Reference> references) {}
