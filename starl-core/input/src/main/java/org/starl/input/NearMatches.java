package org.starl.input;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Locale;

/** Suggests known names for a misspelt one. */
public final class NearMatches {

  private static final int MOST = 3;

  private NearMatches() {}

  /** Up to three of {@code known} that look like {@code word}, the nearest first. */
  public static List<String> of(String word, Collection<String> known) {
    List<String> near = new ArrayList<>();
    String wanted = word.toLowerCase(Locale.ROOT);
    int furthest = Math.max(2, wanted.length() / 3);
    for (int distance = 0; distance <= furthest; distance++) {
      for (String candidate : known) {
        if (near.size() < MOST && distance(wanted, candidate, furthest) == distance) {
          near.add(candidate);
        }
      }
    }
    return near;
  }

  /** {@code ; did you mean a or b?}, or the whole list if no key is similar. */
  public static String hint(String word, Collection<String> known) {
    List<String> near = of(word, known);
    return near.isEmpty()
        ? "; expected one of " + String.join(", ", known)
        : "; did you mean " + String.join(" or ", near) + "?";
  }

  private static int distance(String wanted, String candidate, int furthest) {
    String name = candidate.toLowerCase(Locale.ROOT);
    if (wanted.length() >= 3 && name.contains(wanted)) {
      return Math.min(1, furthest);
    }
    return editDistance(wanted, name);
  }

  /** Insertions, deletions and replacements that lead from one to the other (Levenshtein). */
  private static int editDistance(String a, String b) {
    int[] row = new int[b.length() + 1];
    for (int j = 0; j <= b.length(); j++) {
      row[j] = j;
    }
    for (int i = 1; i <= a.length(); i++) {
      int diagonal = row[0];
      row[0] = i;
      for (int j = 1; j <= b.length(); j++) {
        int replaced = diagonal + (a.charAt(i - 1) == b.charAt(j - 1) ? 0 : 1);
        diagonal = row[j];
        row[j] = Math.min(replaced, 1 + Math.min(row[j], row[j - 1]));
      }
    }
    return row[b.length()];
  }
}
