package org.starl.lang.read;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.antlr.v4.runtime.CommonTokenStream;
import org.antlr.v4.runtime.ParserRuleContext;
import org.antlr.v4.runtime.Token;
import org.antlr.v4.runtime.misc.Interval;
import org.starl.lang.grammar.StarlLexer;

/** Texts of a source: comments, and parts of it on one line. */
final class SourceText {

  private final CommonTokenStream tokens;

  SourceText(CommonTokenStream tokens) {
    this.tokens = tokens;
  }

  /** As written, on one line. */
  static String of(ParserRuleContext at) {
    if (at.getStop() == null) {
      return at.getText();
    }
    return at.getStart()
        .getInputStream()
        .getText(new Interval(at.getStart().getStartIndex(), at.getStop().getStopIndex()))
        .replaceAll("//[^\n]*", "")
        .replaceAll("\\s+", " ")
        .strip();
  }

  /** The lines of comment just before {@code at}: an empty line ends them. */
  List<String> before(ParserRuleContext at) {
    List<String> lines = new ArrayList<>();
    int line = at.getStart().getLine();
    for (int i = at.getStart().getTokenIndex() - 1; i >= 0; i--) {
      Token token = tokens.get(i);
      if (token.getType() == StarlLexer.SPACE) {
        continue;
      }
      if (token.getType() != StarlLexer.COMMENT || token.getLine() != line - 1 || !isAlone(i)) {
        break;
      }
      lines.add(comment(token));
      line--;
    }
    Collections.reverse(lines);
    return List.copyOf(lines);
  }

  /** The comment after {@code last} on its line; empty if there is none. */
  String after(Token last) {
    for (int i = last.getTokenIndex() + 1; i < tokens.size(); i++) {
      Token token = tokens.get(i);
      boolean isCode = token.getChannel() == Token.DEFAULT_CHANNEL && !token.getText().equals(",");
      if (token.getLine() != last.getLine() || isCode) {
        return "";
      }
      if (token.getType() == StarlLexer.COMMENT) {
        return comment(token);
      }
    }
    return "";
  }

  /** Whether no other token stands on the line before token {@code index}. */
  private boolean isAlone(int index) {
    Token token = tokens.get(index);
    for (int i = index - 1; i >= 0; i--) {
      Token before = tokens.get(i);
      if (before.getType() != StarlLexer.SPACE) {
        return before.getLine() != token.getLine();
      }
    }
    return true;
  }

  private static String comment(Token token) {
    String text = token.getText().substring(2);
    return text.startsWith(" ") ? text.substring(1).stripTrailing() : text.stripTrailing();
  }
}
