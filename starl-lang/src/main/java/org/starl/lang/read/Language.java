package org.starl.lang.read;

import java.util.List;

/** Names that the language defines, besides the words of its grammar. */
final class Language {

  /** Functions of any type of option or list. */
  static final List<String> WORDS = List.of("some", "the", "head", "tail", "elements");

  private Language() {}

  /** The name among {@code names} that is written most like {@code wanted}; empty if none is near. */
  static String nearest(String wanted, List<String> names) {
    String best = "";
    int least = Math.max(1, wanted.length() / 3) + 1;
    for (String name : names) {
      int distance = distance(wanted, name);
      if (distance < least) {
        least = distance;
        best = name;
      }
    }
    return best;
  }

  /** The number of letters to add, drop or change (Levenshtein's distance). */
  private static int distance(String a, String b) {
    int[] row = new int[b.length() + 1];
    for (int j = 0; j <= b.length(); j++) {
      row[j] = j;
    }
    for (int i = 1; i <= a.length(); i++) {
      int diagonal = row[0];
      row[0] = i;
      for (int j = 1; j <= b.length(); j++) {
        int change = diagonal + (a.charAt(i - 1) == b.charAt(j - 1) ? 0 : 1);
        diagonal = row[j];
        row[j] = Math.min(change, 1 + Math.min(row[j], row[j - 1]));
      }
    }
    return row[b.length()];
  }
}
