package org.starl.primitives.membership;

import java.util.Collection;
import java.util.Collections;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.regex.Pattern;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;

/**
 * Sets of section names: checked, sorted, immutable.
 *
 * <p>A name may end in a <em>mode</em>: {@code aisle/east}. Robots share a section in one mode, any
 * number of them, or at most k if the mode ends in a <em>capacity</em>: {@code aisle/east*2}. Two
 * modes of one section exclude each other; so do two capacities, and a name without a mode excludes
 * all names of its section.
 */
public final class Sections {

  /** That many names of {@link #MAX_LENGTH} fit one datagram together with two ids. */
  public static final int MAX_COUNT = 32;

  public static final int MAX_LENGTH = 32;

  public static final SortedSet<String> NONE = Collections.unmodifiableSortedSet(new TreeSet<>());

  /** Their number (u8), and the names in ascending order, so that equal sets have equal bytes. */
  public static final Shape<SortedSet<String>> SHAPE =
      Shapes.set(Shapes.TEXT.where(Sections::check), MAX_COUNT);

  private static final Pattern NAME =
      Pattern.compile("[A-Za-z0-9_.:-]+(/[A-Za-z0-9_.:-]+([*][1-9][0-9]{0,2})?)?");

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
          "section '"
              + name
              + "': expected 1 to 32 of A-Z a-z 0-9 _ - . : with, at the end, perhaps"
              + " a mode (/east) and its capacity, 1 to 999 (*2)");
    }
  }

  /** Whether the names are of one section. */
  static boolean isSamePlace(String a, String b) {
    int end = placeEnd(a);
    return end == placeEnd(b) && a.regionMatches(0, b, 0, end);
  }

  /** The section of {@code name}, without mode and capacity. */
  public static String place(String name) {
    return name.substring(0, placeEnd(name));
  }

  private static int placeEnd(String name) {
    int slash = name.indexOf('/');
    return slash < 0 ? name.length() : slash;
  }

  /** How many robots may have {@code name} together; {@code Integer.MAX_VALUE} for any number. */
  public static int capacity(String name) {
    int star = name.indexOf('*');
    if (star >= 0) {
      return Integer.parseInt(name.substring(star + 1));
    }
    return name.indexOf('/') < 0 ? 1 : Integer.MAX_VALUE;
  }

  /** Whether no two robots may have {@code a} and {@code b} together. */
  public static boolean exclude(String a, String b) {
    return compete(a, b) && (!a.equals(b) || capacity(a) == 1);
  }

  /** Whether robots that have {@code a} can keep another one from {@code b}: also by their number. */
  public static boolean compete(String a, String b) {
    return isSamePlace(a, b) && (!a.equals(b) || capacity(a) < Integer.MAX_VALUE);
  }

  /** Whether one of {@code a} excludes one of {@code b}. */
  public static boolean exclude(Collection<String> a, Collection<String> b) {
    return a.stream().anyMatch(one -> b.stream().anyMatch(other -> exclude(one, other)));
  }

  /** Whether one of {@code a} competes with one of {@code b}. */
  public static boolean compete(Collection<String> a, Collection<String> b) {
    return a.stream().anyMatch(one -> b.stream().anyMatch(other -> compete(one, other)));
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

  /** Whether one of {@code names} has a mode. */
  public static boolean haveMode(SortedSet<String> names) {
    return names.stream().anyMatch(name -> name.indexOf('/') >= 0);
  }

  /** Whether {@code name} has a mode with a capacity. */
  public static boolean isLimited(String name) {
    return name.indexOf('*') >= 0;
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
    return name.length() <= MAX_LENGTH && NAME.matcher(name).matches();
  }
}
