package org.starl.lang.java;

import java.util.List;
import org.starl.lang.prove.Prover;
import org.starl.lang.read.SourceErrors;
import org.starl.lang.read.SourceReader;
import org.starl.lang.tree.Automaton;

/** Reads and proves the automata of tests. */
final class Sources {

  private static final int MOST_STEPS = 10_000_000;

  private Sources() {}

  /** The first automaton of a file {@code x.starl} with this text. */
  static Automaton read(String text) throws SourceErrors {
    return new SourceReader().read("x.starl", text).getFirst();
  }

  /** The lines that {@code starl prove} prints of it. */
  static List<String> proved(String text) throws SourceErrors {
    return new Prover(read(text), MOST_STEPS, (title, script) -> {}).prove().lines("x.starl");
  }
}
