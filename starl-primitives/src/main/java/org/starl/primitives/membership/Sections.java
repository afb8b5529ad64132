package org.starl.primitives.membership;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import org.starl.comms.WireFormatException;
import org.starl.comms.WireReader;
import org.starl.comms.WireWriter;

/** Sets of section names: checked, sorted, immutable. */
public final class Sections {

  /** That many names of {@link #MAX_LENGTH} fit one datagram together with two ids. */
  public static final int MAX_COUNT = 32;

  public static final int MAX_LENGTH = 32;

  public static final SortedSet<String> NONE = Collections.unmodifiableSortedSet(new TreeSet<>());

  private Sections() {}

  /**
   * A copy of {@code names}.
   *
   * @throws IllegalArgumentException if there are too many, or one is no valid name
   */
  public static SortedSet<String> copyOf(Collection<String> names) {
    TreeSet<String> copy = new TreeSet<>(names);
    if (copy.size() > MAX_COUNT) {
      throw new IllegalArgumentException(
          copy.size() + " sections: expected at most " + MAX_COUNT + " in one request");
    }
    for (String name : copy) {
      if (!isValid(name)) {
        throw new IllegalArgumentException(
            "section '" + name + "': expected 1 to 32 of A-Z a-z 0-9 _ - . :");
      }
    }
    return Collections.unmodifiableSortedSet(copy);
  }

  /** Whether the sets have a name in common. */
  public static boolean meet(SortedSet<String> a, SortedSet<String> b) {
    return !Collections.disjoint(a, b);
  }

  public static SortedSet<String> without(SortedSet<String> from, Collection<String> taken) {
    TreeSet<String> rest = new TreeSet<>(from);
    rest.removeAll(taken);
    return Collections.unmodifiableSortedSet(rest);
  }

  public static SortedSet<String> common(SortedSet<String> a, SortedSet<String> b) {
    TreeSet<String> both = new TreeSet<>(a);
    both.retainAll(b);
    return Collections.unmodifiableSortedSet(both);
  }

  /** The names with single spaces between them; empty for none. */
  public static String text(SortedSet<String> names) {
    return String.join(" ", names);
  }

  /**
   * Reads what {@link #text} wrote.
   *
   * @throws IllegalArgumentException if {@code text} is malformed
   */
  public static SortedSet<String> parse(String text) {
    return copyOf(split(text, ' '));
  }

  /**
   * The parts between separators; none of an empty text. Monitors read many texts: this is less code
   * than {@link String#split}.
   */
  static List<String> split(String text, char separator) {
    List<String> parts = new ArrayList<>();
    int from = 0;
    for (int end = text.indexOf(separator); end >= 0; end = text.indexOf(separator, from)) {
      parts.add(text.substring(from, end));
      from = end + 1;
    }
    if (!text.isEmpty()) {
      parts.add(text.substring(from));
    }
    return parts;
  }

  /** Writes their number (u8) and the names in ascending order. */
  public static void write(SortedSet<String> names, WireWriter out) {
    out.u8(names.size());
    for (String name : names) {
      out.string(name);
    }
  }

  /** Reads what {@link #write} wrote; names must be in ascending order, so that equal sets have equal bytes. */
  public static SortedSet<String> read(WireReader in) {
    int count = in.u8();
    if (count > MAX_COUNT) {
      throw new WireFormatException(count + " sections");
    }
    TreeSet<String> names = new TreeSet<>();
    for (int i = 0; i < count; i++) {
      String name = in.string();
      if (!isValid(name) || (!names.isEmpty() && names.last().compareTo(name) >= 0)) {
        throw new WireFormatException("section name");
      }
      names.add(name);
    }
    return Collections.unmodifiableSortedSet(names);
  }

  private static boolean isValid(String name) {
    for (int i = 0; i < name.length(); i++) {
      if (!isLetter(name.charAt(i))) {
        return false;
      }
    }
    return !name.isEmpty() && name.length() <= MAX_LENGTH;
  }

  private static boolean isLetter(char c) {
    return (c >= 'a' && c <= 'z')
        || (c >= 'A' && c <= 'Z')
        || (c >= '0' && c <= '9')
        || "_-.:".indexOf(c) >= 0;
  }
}
