package org.starl.lang.check;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.starl.lang.eval.Domain;
import org.starl.lang.eval.Domain.Renaming;

/** The values of one part of the state that were met, each with a number: states share them. */
final class Pool {

  private static final int UNKNOWN = -1;

  private final Domain domain;
  private final List<Renaming> renamings;
  private final Map<Object, Integer> numbers = new HashMap<>();
  private final List<Object> values = new ArrayList<>();

  /** For each value, the number of its renamed value under each renaming. */
  private final List<int[]> renamed = new ArrayList<>();

  Pool(Domain domain, List<Renaming> renamings) {
    this.domain = domain;
    this.renamings = renamings;
  }

  int number(Object value) {
    Integer known = numbers.get(value);
    if (known != null) {
      return known;
    }
    int number = values.size();
    numbers.put(value, number);
    values.add(value);
    int[] unknown = new int[renamings.size()];
    Arrays.fill(unknown, UNKNOWN);
    renamed.add(unknown);
    return number;
  }

  Object value(int number) {
    return values.get(number);
  }

  /** The number of the value under a renaming. */
  int renamed(int number, int renaming) {
    int[] known = renamed.get(number);
    if (known[renaming] == UNKNOWN) {
      known[renaming] = number(domain.renamed(values.get(number), renamings.get(renaming)));
    }
    return known[renaming];
  }
}
