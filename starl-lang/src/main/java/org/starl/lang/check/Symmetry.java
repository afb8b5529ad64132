package org.starl.lang.check;

import java.io.DataInput;
import java.io.DataOutput;
import java.io.IOException;
import java.nio.IntBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import org.starl.lang.eval.Domain;
import org.starl.lang.eval.Machine;
import org.starl.lang.eval.Row;
import org.starl.lang.eval.Successors;

/**
 * Represents states that differ in the names of elements alone by one of them. The elements of a
 * type are put in the order of what the state says of each. Where it says the same of several, and
 * to exchange two of them changes the state, all their orders are tried, and the least state is
 * taken.
 */
final class Symmetry implements Successors.Numbers {

  /** So many orders are tried for a state, at most. */
  private static final int MOST = 5040;

  /** An element of an opaque type. */
  record Element(String type, int number) {}

  /** What stands for each element. */
  final class Order implements Domain.Renaming {

    /** Each order has another number. */
    final int number;

    private final int[] to;

    private Order(int[] to) {
      this.to = to;
      number = orders.size();
    }

    @Override
    public int of(String type, int element) {
      Integer first = firsts.get(type);
      return first == null ? element : to[first + element];
    }

    boolean isIdentity() {
      return number == 0;
    }
  }

  private final List<Element> elements = new ArrayList<>();

  /** The place of each type's first element. */
  private final Map<String, Integer> firsts = new LinkedHashMap<>();

  private final List<Pool> pools = new ArrayList<>();
  private final int[] identity;

  /** For each element, the place of its type's first one. */
  private final int[] firstOf;

  private final Order unchanged;
  private final @Nullable Order[][] exchanges;
  private final Map<IntBuffer, Order> orders = new HashMap<>();
  private final SortedSet<String> tooMany = new TreeSet<>();

  /**
   * @param sizes the number of elements of each opaque type
   * @param isOn whether elements are renamed
   */
  Symmetry(Machine machine, Map<String, Integer> sizes, boolean isOn) {
    sizes.forEach((type, size) -> {
      if (isOn && size > 1) {
        firsts.put(type, elements.size());
        IntStream.range(0, size).forEach(e -> elements.add(new Element(type, e)));
      }
    });
    identity = elements.stream().mapToInt(Element::number).toArray();
    exchanges = new Order[identity.length][identity.length];
    firstOf = new int[identity.length];
    for (int e = 0; e < firstOf.length; e++) {
      firstOf[e] = e - identity[e];
    }
    unchanged = new Order(identity);
    orders.put(IntBuffer.wrap(identity), unchanged);
    machine.parts().forEach(part -> pools.add(new Pool(part.domain(), elements)));
  }

  /** Two elements of a type stand for each other, all others for themselves. */
  private Order exchange(int a, int b) {
    if (exchanges[a][b] == null) {
      int[] to = identity.clone();
      to[a] = identity[b];
      to[b] = identity[a];
      exchanges[a][b] = order(to);
    }
    return exchanges[a][b];
  }

  private Order order(int[] to) {
    return Arrays.equals(to, identity)
        ? unchanged
        : orders.computeIfAbsent(IntBuffer.wrap(to), any -> new Order(to));
  }

  /** The types whose elements are renamed. */
  List<String> types() {
    return List.copyOf(firsts.keySet());
  }

  /** Those of them with so many orders that in some state not all were tried. */
  List<String> tooMany() {
    return List.copyOf(tooMany);
  }

  /** The numbers that stand for the state, and for all that differ from it in names alone. */
  int[] representative(Row state) {
    return representative(
        IntStream.range(0, pools.size()).map(i -> number(i, state.get(i))).toArray());
  }

  /** The same, of the state of these numbers. */
  int[] representative(int[] numbers) {
    if (elements.isEmpty()) {
      return numbers;
    }
    int width = pools.size();
    int @Nullable [] least = null;
    for (int[] to : new Arrangements(numbers).all()) {
      Order order = order(to);
      int[] renamed = new int[width];
      for (int i = 0; i < width; i++) {
        renamed[i] = pools.get(i).renamed(numbers[i], order);
      }
      least = least == null || Arrays.compare(renamed, least) < 0 ? renamed : least;
    }
    return Objects.requireNonNull(least);
  }

  /** The orders of the elements of a state that may give the least one. */
  private final class Arrangements {

    private final int[] numbers;

    /** What the state says of each element. */
    private final long[] marks = new long[elements.size()];

    /** The elements of each type by their marks. */
    private final int[] sorted = new int[marks.length];

    /** For each element, the first that can be exchanged with it, and the state stays as it is. */
    private final int[] twins = new int[marks.length];

    Arrangements(int[] numbers) {
      this.numbers = numbers;
      for (int i = 0; i < numbers.length; i++) {
        long[] of = pools.get(i).marks(numbers[i]);
        for (int e = 0; e < marks.length; e++) {
          marks[e] = Domain.mix(marks[e], of[e]);
        }
      }
      for (int e = 0; e < sorted.length; e++) {
        int place = e;
        while (place > 0
            && firstOf[e] == firstOf[sorted[place - 1]]
            && marks[sorted[place - 1]] > marks[e]) {
          sorted[place] = sorted[--place];
        }
        sorted[place] = e;
      }
      for (int place = 0; place < sorted.length; place++) {
        int element = sorted[place];
        twins[element] = element;
        for (int at = place - 1; at >= 0 && isTie(place, at); at--) {
          int other = sorted[at];
          if (twins[other] == other && isSameBesides(other, element)) {
            twins[element] = other;
            break;
          }
        }
      }
    }

    private boolean isTie(int place, int other) {
      int a = sorted[place];
      int b = sorted[other];
      return marks[a] == marks[b] && firstOf[a] == firstOf[b];
    }

    private boolean isSameBesides(int a, int b) {
      Order exchange = exchange(a, b);
      for (int i = 0; i < numbers.length; i++) {
        if (pools.get(i).renamed(numbers[i], exchange) != numbers[i]) {
          return false;
        }
      }
      return true;
    }

    /** All whose states may differ, if they are not too many; else some of them. */
    List<int[]> all() {
      int[] places = new int[sorted.length];
      List<Integer> ties = new ArrayList<>();
      for (int from = 0, to; from < sorted.length; from = to) {
        boolean areTwins = true;
        for (to = from; to < sorted.length && isTie(from, to); to++) {
          places[sorted[to]] = to - firstOf[sorted[to]];
          areTwins &= twins[sorted[to]] == sorted[from];
        }
        if (!areTwins) {
          ties.add(from);
          ties.add(to);
        }
      }
      List<int[]> all = List.of(places);
      for (int i = 0; i < ties.size(); i += 2) {
        List<int[]> longer = new ArrayList<>();
        for (int[] each : all) {
          place(
              ties.get(i), ties.get(i), ties.get(i + 1), new boolean[sorted.length], each, longer);
        }
        all = longer;
      }
      return all;
    }

    /** Gives the place {@code at}, of those of a tie, to one of each kind of twins that has none. */
    private void place(
        int at, int from, int to, boolean[] isPlaced, int[] places, List<int[]> all) {
      if (at == to) {
        all.add(places.clone());
        return;
      }
      boolean[] isTried = new boolean[sorted.length];
      for (int p = from; p < to; p++) {
        int element = sorted[p];
        if (isPlaced[element] || isTried[twins[element]]) {
          continue;
        }
        if (all.size() >= MOST) {
          tooMany.add(elements.get(element).type());
          return;
        }
        isTried[twins[element]] = true;
        isPlaced[element] = true;
        places[element] = at - firstOf[element];
        place(at + 1, from, to, isPlaced, places, all);
        isPlaced[element] = false;
      }
    }
  }

  /** The values that were met. */
  void write(DataOutput out) throws IOException {
    for (Pool pool : pools) {
      pool.write(out);
    }
    out.writeInt(tooMany.size());
    for (String type : tooMany) {
      out.writeUTF(type);
    }
  }

  /** Meets the values as they were written; none was met yet. */
  void read(DataInput in) throws IOException {
    for (Pool pool : pools) {
      pool.read(in);
    }
    for (int left = in.readInt(); left > 0; left--) {
      tooMany.add(in.readUTF());
    }
  }

  @Override
  public int number(int part, Object value) {
    return pools.get(part).number(value);
  }

  @Override
  public Object value(int part, int number) {
    return pools.get(part).value(number);
  }
}
