package org.starl.lang.pvs;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.Iterator;
import java.util.List;

/** A text with places where a line may end: Wadler, "A prettier printer". */
sealed interface Doc {

  /** A line is at most this long, if its words allow it. */
  int WIDTH = 100;

  /** Never broken. */
  record Text(String text) implements Doc {}

  /** A space, or the end of a line. */
  enum Space implements Doc {
    /** The line ends here if the group around it does not fit on one line. */
    LINE,
    /** The line ends here if its group does not fit, and what follows does not fit either. */
    SOFT
  }

  /** One after the other. */
  record Cat(List<Doc> parts) implements Doc {}

  /** Lines that begin inside are indented further. */
  record Nest(int by, Doc of) implements Doc {}

  /** On one line if it fits. */
  record Group(Doc of) implements Doc {}

  /** Parts one after the other: texts and docs. */
  static Doc of(Object... parts) {
    List<Doc> docs = new ArrayList<>();
    for (Object part : parts) {
      docs.add(part instanceof Doc doc ? doc : new Text(part.toString()));
    }
    return new Cat(List.copyOf(docs));
  }

  /** {@code parts} with {@code between} between them: texts and docs. */
  static Doc join(List<Doc> parts, Object... between) {
    List<Object> all = new ArrayList<>();
    for (Doc part : parts) {
      if (!all.isEmpty()) {
        all.addAll(List.of(between));
      }
      all.add(part);
    }
    return of(all.toArray());
  }

  /** These parts on one line, or with further lines indented by {@code by}. */
  static Doc group(int by, Object... parts) {
    return new Group(new Nest(by, of(parts)));
  }

  /** The text, where the first line begins at {@code indent}. */
  default String text(int indent) {
    StringBuilder text = new StringBuilder(" ".repeat(indent));
    Deque<Item> rest = new ArrayDeque<>();
    rest.push(new Item(indent, false, this));
    int column = indent;
    while (!rest.isEmpty()) {
      Item item = rest.pop();
      switch (item.doc) {
        case Text(String word) -> {
          text.append(word);
          column += word.length();
        }
        case Space space -> {
          if (item.isFlat || (space == Space.SOFT && Item.fits(WIDTH - column - 1, rest))) {
            text.append(' ');
            column++;
          } else {
            text.append('\n').append(" ".repeat(item.indent));
            column = item.indent;
          }
        }
        case Group(Doc of) -> {
          rest.push(new Item(item.indent, true, of));
          if (!item.isFlat && !Item.fits(WIDTH - column, rest)) {
            rest.pop();
            rest.push(new Item(item.indent, false, of));
          }
        }
        default -> item.parts().descendingIterator().forEachRemaining(rest::push);
      }
    }
    return text.toString();
  }

  /** A doc that is still to be written. */
  record Item(int indent, boolean isFlat, Doc doc) {

    /** The parts of a doc that is no single text, space or group. */
    private Deque<Item> parts() {
      Deque<Item> parts = new ArrayDeque<>();
      switch (doc) {
        case Cat(List<Doc> all) -> all.forEach(part -> parts.add(new Item(indent, isFlat, part)));
        case Nest(int by, Doc of) -> parts.add(new Item(indent + by, isFlat, of));
        default -> throw new IllegalStateException(doc.toString());
      }
      return parts;
    }

    /** Whether {@code rest}, up to where its line may end, has at most {@code room} characters. */
    private static boolean fits(int room, Deque<Item> rest) {
      Iterator<Item> later = rest.iterator();
      Deque<Item> now = new ArrayDeque<>();
      int left = room;
      while (left >= 0 && (!now.isEmpty() || later.hasNext())) {
        Item item = now.isEmpty() ? later.next() : now.pop();
        switch (item.doc) {
          case Text(String word) -> left -= word.length();
          case Space space -> {
            if (!item.isFlat) {
              return true;
            }
            left--;
          }
          case Group(Doc of) -> now.push(new Item(item.indent, true, of));
          default -> item.parts().descendingIterator().forEachRemaining(now::push);
        }
      }
      return left >= 0;
    }
  }
}
