package org.starl.id;

import org.jspecify.annotations.Nullable;

/**
 * A robot's name, unique in its deployment: 1 to 32 letters, digits, {@code _}, {@code -} or {@code
 * .}, starting with a letter, without a number after the last dot: {@code bot0.2} is a {@link ProcessId}.
 * Natural order: {@code bot2} before {@code bot10}.
 */
public final class RobotId implements Comparable<RobotId> {

  public static final int MAX_LENGTH = 32;

  /** What a name is, for messages. */
  public static final String FORM =
      "a letter, then up to 31 of A-Z a-z 0-9 _ - ., and no number after the last dot";

  private final String name;

  // Compared before the name, which is another object and usually not in the cache.
  private final int hash;

  // Most names are a stem of up to eight characters and a number. Among those of one stem, the
  // number alone decides the order. Other names have the stem 0.
  private final long stem;
  private final int number;

  public RobotId(String name) {
    if (!isValid(name)) {
      throw new IllegalArgumentException("robot name '" + name + "': expected " + FORM);
    }
    this.name = name;
    this.hash = name.hashCode();
    int digits = startOfNumber(name);
    this.number = number(name, digits);
    this.stem = number < 0 || digits > Long.BYTES ? 0 : stem(name, digits);
  }

  /** How many characters are before the digits at the end. */
  private static int startOfNumber(String name) {
    int end = name.length();
    while (isDigit(name.charAt(end - 1))) {
      end--;
    }
    return end;
  }

  /** The characters before {@code end} in one number: they are ASCII. */
  private static long stem(String name, int end) {
    long stem = 0;
    for (int i = 0; i < end; i++) {
      stem = stem << Byte.SIZE | name.charAt(i);
    }
    return stem;
  }

  /** The value of the digits from {@code from}; -1 for none, a leading zero, or more than nine. */
  private static int number(String name, int from) {
    int digits = name.length() - from;
    boolean isPlain = digits > 0 && digits <= 9 && (digits == 1 || name.charAt(from) != '0');
    return isPlain ? Integer.parseInt(name.substring(from)) : -1;
  }

  public String name() {
    return name;
  }

  public static boolean isValid(String name) {
    if (name.isEmpty() || name.length() > MAX_LENGTH || !isLetter(name.charAt(0))) {
      return false;
    }
    for (int i = 1; i < name.length(); i++) {
      char c = name.charAt(i);
      if (!isLetter(c) && !isDigit(c) && c != '_' && c != '-' && c != '.') {
        return false;
      }
    }
    int digits = startOfNumber(name);
    return digits == name.length() || name.charAt(digits - 1) != '.';
  }

  /** Compares runs of digits by value, other characters one by one; a total order. */
  @Override
  public int compareTo(RobotId other) {
    if (this == other) {
      return 0;
    }
    if (stem == other.stem && stem != 0) {
      return Integer.compare(number, other.number);
    }
    String a = name;
    String b = other.name;
    int i = 0;
    int j = 0;
    while (i < a.length() && j < b.length()) {
      if (isDigit(a.charAt(i)) && isDigit(b.charAt(j))) {
        int iEnd = endOfDigits(a, i);
        int jEnd = endOfDigits(b, j);
        int byValue = compareDigits(a, i, iEnd, b, j, jEnd);
        if (byValue != 0) {
          return byValue;
        }
        i = iEnd;
        j = jEnd;
      } else {
        int byCharacter = Character.compare(a.charAt(i), b.charAt(j));
        if (byCharacter != 0) {
          return byCharacter;
        }
        i++;
        j++;
      }
    }
    int byRest = Integer.compare(a.length() - i, b.length() - j);
    // Equal values with different leading zeros are different names.
    return byRest != 0 ? byRest : a.compareTo(b);
  }

  private static int compareDigits(String a, int i, int iEnd, String b, int j, int jEnd) {
    int from = skipZeros(a, i, iEnd);
    int otherFrom = skipZeros(b, j, jEnd);
    int byLength = Integer.compare(iEnd - from, jEnd - otherFrom);
    if (byLength != 0) {
      return byLength;
    }
    for (int k = 0; k < iEnd - from; k++) {
      int byDigit = Character.compare(a.charAt(from + k), b.charAt(otherFrom + k));
      if (byDigit != 0) {
        return byDigit;
      }
    }
    return 0;
  }

  private static int skipZeros(String s, int from, int end) {
    int i = from;
    while (i < end - 1 && s.charAt(i) == '0') {
      i++;
    }
    return i;
  }

  private static int endOfDigits(String s, int from) {
    int i = from;
    while (i < s.length() && isDigit(s.charAt(i))) {
      i++;
    }
    return i;
  }

  private static boolean isLetter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
  }

  private static boolean isDigit(char c) {
    return c >= '0' && c <= '9';
  }

  @Override
  public boolean equals(@Nullable Object other) {
    return this == other
        || (other instanceof RobotId that && hash == that.hash && name.equals(that.name));
  }

  /** The hash code of the name. */
  @Override
  public int hashCode() {
    return hash;
  }

  @Override
  public String toString() {
    return name;
  }
}
