package org.starl.lang.prove;

import java.util.List;
import java.util.Optional;
import org.starl.lang.tree.Pos;

/**
 * Something that is to hold of an automaton, and what came of it.
 *
 * @param subject an invariant, an action, a function, or {@code start}
 * @param lines what shows it, such as two states
 * @param action the name of the action that does not keep it
 * @param pos of the operation that has no value
 */
public record Claim(
    String subject,
    Verdict verdict,
    String text,
    List<String> lines,
    Optional<String> action,
    Optional<Pos> pos) {

  /** One that is about no action alone, and no operation. */
  Claim(String subject, Verdict verdict, String text, List<String> lines) {
    this(subject, verdict, text, lines, Optional.empty(), Optional.empty());
  }

  /** What came of it. */
  public enum Verdict {
    /** It holds for any number of elements of the opaque types. */
    PROVED,
    /** It holds for 1 to {@link Prover#MOST_ELEMENTS} elements of each opaque type; more are not decided. */
    PROVED_SMALL,
    /** It does not hold. */
    FAILED,
    /** It holds if other invariants do, and these are not proved. */
    DEPENDS,
    /** Z3 has not decided it within the limit. */
    UNDECIDED
  }

  /** Whether it holds. */
  public boolean isGood() {
    return verdict == Verdict.PROVED || verdict == Verdict.PROVED_SMALL;
  }
}
