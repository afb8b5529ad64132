package org.starl.lang.check;

import java.io.DataInput;
import java.io.DataOutput;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.starl.lang.eval.Domain;

/** The values of one part of the state that were met, each with a number: states share them. */
final class Pool {

  /** The renamed values under so many renamings are kept: there may be thousands. */
  private static final int KEPT = 64;

  private final Domain domain;
  private final List<Symmetry.Element> elements;
  private final Map<Object, Integer> numbers = new HashMap<>();
  private final List<Object> values = new ArrayList<>();
  private final List<long[]> marks = new ArrayList<>();

  /** For each value, the numbers of its renamed values plus 1, under the first renamings. */
  private final List<int[]> renamed = new ArrayList<>();

  Pool(Domain domain, List<Symmetry.Element> elements) {
    this.domain = domain;
    this.elements = elements;
  }

  int number(Object value) {
    Integer known = numbers.get(value);
    if (known != null) {
      return known;
    }
    int number = values.size();
    numbers.put(value, number);
    values.add(value);
    long[] each = new long[elements.size()];
    for (int e = 0; e < each.length; e++) {
      Symmetry.Element of = elements.get(e);
      each[e] =
          domain.mark(value, (type, at) -> type.equals(of.type()) && at == of.number() ? 1 : 0);
    }
    marks.add(each);
    renamed.add(new int[0]);
    return number;
  }

  void write(DataOutput out) throws IOException {
    out.writeInt(values.size());
    for (Object value : values) {
      ValueForm.write(value, out);
    }
  }

  void read(DataInput in) throws IOException {
    for (int left = in.readInt(); left > 0; left--) {
      number(ValueForm.read(in));
    }
  }

  Object value(int number) {
    return values.get(number);
  }

  /** For each element, a number that tells where the value has it, and no element's name. */
  long[] marks(int number) {
    return marks.get(number);
  }

  /** The number of the value under a renaming. */
  int renamed(int number, Symmetry.Order order) {
    if (order.isIdentity()) {
      return number;
    }
    if (order.number >= KEPT) {
      return number(domain.renamed(values.get(number), order));
    }
    int[] known = renamed.get(number);
    if (known.length <= order.number) {
      known = Arrays.copyOf(known, Math.min(KEPT, 2 * order.number));
      renamed.set(number, known);
    }
    if (known[order.number] == 0) {
      known[order.number] = 1 + number(domain.renamed(values.get(number), order));
    }
    return known[order.number] - 1;
  }
}
