package org.starl.primitives.membership;

import java.util.Collection;
import java.util.Collections;
import java.util.SortedSet;
import java.util.TreeSet;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;

/** Sets of section names: checked, sorted, immutable. */
public final class Sections {

  /** That many names of {@link #MAX_LENGTH} fit one datagram together with two ids. */
  public static final int MAX_COUNT = 32;

  public static final int MAX_LENGTH = 32;

  public static final SortedSet<String> NONE = Collections.unmodifiableSortedSet(new TreeSet<>());

  /** Their number (u8), and the names in ascending order, so that equal sets have equal bytes. */
  public static final Shape<SortedSet<String>> SHAPE =
      Shapes.set(Shapes.TEXT.where(Sections::check), MAX_COUNT);

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
    copy.forEach(Sections::check);
    return Collections.unmodifiableSortedSet(copy);
  }

  private static void check(String name) {
    if (!isValid(name)) {
      throw new IllegalArgumentException(
          "section '" + name + "': expected 1 to 32 of A-Z a-z 0-9 _ - . :");
    }
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

  public static SortedSet<String> union(SortedSet<String> a, Collection<String> b) {
    TreeSet<String> both = new TreeSet<>(a);
    both.addAll(b);
    return Collections.unmodifiableSortedSet(both);
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
