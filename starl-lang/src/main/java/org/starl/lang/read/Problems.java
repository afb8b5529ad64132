package org.starl.lang.read;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import org.antlr.v4.runtime.ParserRuleContext;
import org.antlr.v4.runtime.Token;
import org.starl.input.NearMatches;
import org.starl.lang.tree.Pos;

/** Collects what is wrong in one source, and what its names mean. */
final class Problems {

  private final String file;
  private final List<SourceError> errors = new ArrayList<>();
  private final List<Reference> references = new ArrayList<>();

  Problems(String file) {
    this.file = file;
  }

  String file() {
    return file;
  }

  void add(Pos pos, String message) {
    add(new SourceError(file, pos, message));
  }

  /** Also of another file. */
  void add(SourceError error) {
    if (!errors.contains(error)) {
      errors.add(error);
    }
  }

  void add(ParserRuleContext at, String message) {
    add(pos(at), message);
  }

  boolean isEmpty() {
    return errors.isEmpty();
  }

  /**
   * Keeps what a name means.
   *
   * @param declaredAt in this source
   */
  void refer(ParserRuleContext at, String meaning, Pos declaredAt) {
    references.add(new Reference(pos(at), at.getText(), meaning, file, declaredAt));
  }

  List<Reference> references() {
    return List.copyOf(references);
  }

  /** In the order of the text. */
  List<SourceError> inOrder() {
    return errors.stream()
        .sorted(
            Comparator.comparingInt((SourceError e) -> e.pos().line())
                .thenComparingInt(e -> e.pos().column()))
        .toList();
  }

  /** What was expected in place of {@code name}, with the known one that looks like it. */
  static String oneOf(String name, Collection<String> known) {
    List<String> near = NearMatches.of(name, known);
    return "expected one of "
        + String.join(", ", known)
        + (near.isEmpty() ? "" : "; is it " + near.getFirst() + "?");
  }

  static Pos pos(Token token) {
    return new Pos(token.getLine(), token.getCharPositionInLine() + 1);
  }

  static Pos pos(ParserRuleContext at) {
    return pos(at.getStart());
  }
}
