package org.starl.primitives.mutex;

import java.util.Collection;
import java.util.Collections;
import java.util.SortedSet;
import java.util.TreeSet;

/** Sets of section names: checked, in order, immutable. */
final class Sections {

  /** As many long names as fit one datagram together with two ids. */
  static final int MAX_COUNT = 32;

  static final int MAX_LENGTH = 32;

  static final SortedSet<String> NONE = Collections.unmodifiableSortedSet(new TreeSet<>());

  private Sections() {}

  /**
   * A copy of {@code names}.
   *
   * @throws IllegalArgumentException if there are too many, or one is no valid name
   */
  static SortedSet<String> copyOf(Collection<String> names) {
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

  static boolean isValid(String name) {
    if (name.isEmpty() || name.length() > MAX_LENGTH) {
      return false;
    }
    for (int i = 0; i < name.length(); i++) {
      char c = name.charAt(i);
      boolean letterOrDigit =
          (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
      if (!letterOrDigit && "_-.:".indexOf(c) < 0) {
        return false;
      }
    }
    return true;
  }

  static boolean meet(SortedSet<String> a, SortedSet<String> b) {
    SortedSet<String> fewer = a.size() <= b.size() ? a : b;
    SortedSet<String> more = a.size() <= b.size() ? b : a;
    for (String name : fewer) {
      if (more.contains(name)) {
        return true;
      }
    }
    return false;
  }

  static SortedSet<String> without(SortedSet<String> from, Collection<String> taken) {
    TreeSet<String> rest = new TreeSet<>(from);
    rest.removeAll(taken);
    return Collections.unmodifiableSortedSet(rest);
  }

  static SortedSet<String> common(SortedSet<String> a, SortedSet<String> b) {
    TreeSet<String> both = new TreeSet<>(a);
    both.retainAll(b);
    return Collections.unmodifiableSortedSet(both);
  }
}
