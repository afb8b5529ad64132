package org.starl.lang.check;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.starl.lang.eval.Domain.Renaming;
import org.starl.lang.eval.Machine;
import org.starl.lang.eval.Row;

/** Represents states that differ in the names of elements alone by one of them. */
final class Symmetry {

  /** So many renamings are tried for a state, at most: of types beyond it, no element is renamed. */
  private static final int MOST = 5040;

  private final List<Pool> pools = new ArrayList<>();
  private final List<String> types = new ArrayList<>();
  private final List<String> tooLarge = new ArrayList<>();
  private final int renamings;

  /**
   * @param sizes the number of elements of each opaque type
   * @param isOn whether elements are renamed
   */
  Symmetry(Machine machine, Map<String, Integer> sizes, boolean isOn) {
    List<Map<String, int[]>> all = new ArrayList<>(List.of(Map.of()));
    if (isOn) {
      for (Map.Entry<String, Integer> type : sizes.entrySet()) {
        if (type.getValue() < 2) {
          continue;
        }
        if (factorial(type.getValue()) * all.size() > MOST) {
          tooLarge.add(type.getKey());
          continue;
        }
        types.add(type.getKey());
        List<Map<String, int[]>> more = new ArrayList<>();
        for (int[] order : orders(type.getValue())) {
          for (Map<String, int[]> renaming : all) {
            Map<String, int[]> longer = new LinkedHashMap<>(renaming);
            longer.put(type.getKey(), order);
            more.add(longer);
          }
        }
        all = more;
      }
    }
    List<Renaming> renaming = new ArrayList<>();
    for (Map<String, int[]> each : all) {
      renaming.add((type, number) -> {
        int[] order = each.get(type);
        return order == null ? number : order[number];
      });
    }
    renamings = renaming.size();
    machine.parts().forEach(part -> pools.add(new Pool(part.domain(), renaming)));
  }

  private static long factorial(int n) {
    long product = 1;
    for (int i = 2; i <= n && product <= MOST; i++) {
      product *= i;
    }
    return product;
  }

  /** The orders of 0..n-1, the usual one first. */
  private static List<int[]> orders(int n) {
    List<int[]> orders = new ArrayList<>();
    if (n == 0) {
      orders.add(new int[0]);
      return orders;
    }
    for (int place = n - 1; place >= 0; place--) {
      for (int[] shorter : orders(n - 1)) {
        int[] order = new int[n];
        System.arraycopy(shorter, 0, order, 0, place);
        order[place] = n - 1;
        System.arraycopy(shorter, place, order, place + 1, n - 1 - place);
        orders.add(order);
      }
    }
    return orders;
  }

  /** The types whose elements are renamed. */
  List<String> types() {
    return List.copyOf(types);
  }

  /** The types whose elements are not renamed: there are too many renamings. */
  List<String> tooLarge() {
    return List.copyOf(tooLarge);
  }

  /** The numbers that stand for the state, and for all that differ from it in names alone. */
  int[] representative(Row state) {
    return representative(state, Row.of(List.of()), new int[0]);
  }

  /**
   * The same, of a state that shares most parts with another one.
   *
   * @param numbersBefore of {@code before}
   */
  int[] representative(Row state, Row before, int[] numbersBefore) {
    int width = pools.size();
    int[] numbers = new int[width];
    for (int i = 0; i < width; i++) {
      boolean isSame = i < numbersBefore.length && state.get(i) == before.get(i);
      numbers[i] = isSame ? numbersBefore[i] : pools.get(i).number(state.get(i));
    }
    int[] least = numbers.clone();
    int[] renamed = new int[width];
    for (int r = 1; r < renamings; r++) {
      int order = 0; // of what is renamed so far: below 0 if it is before the least
      for (int i = 0; i < width && order <= 0; i++) {
        renamed[i] = pools.get(i).renamed(numbers[i], r);
        order = order == 0 ? Integer.compare(renamed[i], least[i]) : order;
      }
      if (order < 0) {
        System.arraycopy(renamed, 0, least, 0, width);
      }
    }
    return least;
  }

  /** The state of these numbers. */
  Row state(int[] numbers) {
    List<Object> values = new ArrayList<>();
    for (int i = 0; i < numbers.length; i++) {
      values.add(pools.get(i).value(numbers[i]));
    }
    return Row.of(values);
  }
}
