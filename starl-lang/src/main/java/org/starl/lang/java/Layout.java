package org.starl.lang.java;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Lays out one statement in lines of at most 100 columns, by the rules of google-java-format: a level
 * that fits stands on one line; else its breaks become lines, all of them, or, of filled ones, those
 * that must.
 */
final class Layout {

  private static final int WIDTH = 100;

  private sealed interface Doc permits Token, Break, Level {
    int width();
  }

  private record Token(String text) implements Doc {
    @Override
    public int width() {
      return text.length();
    }
  }

  /**
   * A place for a line's end.
   *
   * @param flat its text if the line does not end
   * @param fills whether the line ends only if what follows does not fit
   */
  private record Break(String flat, boolean fills) implements Doc {
    @Override
    public int width() {
      return flat.length();
    }
  }

  private static final class Level implements Doc {
    private final int indent;
    private final List<Doc> docs = new ArrayList<>();

    private Level(int indent) {
      this.indent = indent;
    }

    @Override
    public int width() {
      return widthOf(docs);
    }
  }

  private final Deque<Level> open = new ArrayDeque<>();
  private final Level whole = new Level(0);
  // Tokens belong to the level of the break before them.
  private Level present = whole;

  private final StringBuilder text = new StringBuilder();
  private int column;

  Layout() {
    open.addLast(whole);
  }

  Layout open(int indent) {
    open.addLast(new Level(indent));
    return this;
  }

  Layout close() {
    Level level = open.removeLast();
    open.getLast().docs.add(level);
    return this;
  }

  Layout token(String token) {
    present.docs.add(new Token(token));
    return this;
  }

  Layout brk(String flat) {
    return brk(flat, false);
  }

  Layout brk(String flat, boolean fills) {
    present = open.getLast();
    present.docs.add(new Break(flat, fills));
    return this;
  }

  /** The length on one line. */
  int width() {
    return whole.width();
  }

  /** The lines, with {@code indent} spaces before each. */
  String text(int indent) {
    text.append(" ".repeat(indent));
    column = indent;
    write(whole, indent);
    return text.append('\n').toString();
  }

  private void write(Doc doc, int indent) {
    switch (doc) {
      case Token token -> append(token.text);
      case Break space -> append(space.flat);
      case Level level -> {
        if (column + level.width() <= WIDTH) {
          level.docs.forEach(each -> write(each, indent));
        } else {
          writeBroken(level, indent + level.indent);
        }
      }
    }
  }

  private void writeBroken(Level level, int indent) {
    List<Doc> part = new ArrayList<>();
    Break before = null;
    boolean mustBreak = false;
    for (Doc doc : level.docs) {
      if (doc instanceof Break next) {
        mustBreak = writePart(before, part, mustBreak, indent);
        before = next;
        part = new ArrayList<>();
      } else {
        part.add(doc);
      }
    }
    writePart(before, part, mustBreak, indent);
  }

  /** Writes what stands between two breaks; returns whether the second one must end the line. */
  private boolean writePart(@Nullable Break before, List<Doc> part, boolean mustBreak, int indent) {
    int width = widthOf(part);
    if (before != null) {
      if (!before.fills || mustBreak || column + before.width() + width > WIDTH) {
        text.append('\n').append(" ".repeat(indent));
        column = indent;
      } else {
        append(before.flat);
      }
    }
    boolean fits = column + width <= WIDTH;
    part.forEach(each -> write(each, indent));
    return !fits;
  }

  private static int widthOf(List<Doc> docs) {
    return docs.stream().mapToInt(Doc::width).sum();
  }

  private void append(String more) {
    text.append(more);
    column += more.length();
  }
}
