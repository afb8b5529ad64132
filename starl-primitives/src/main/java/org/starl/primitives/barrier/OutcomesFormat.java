package org.starl.primitives.barrier;

import java.util.List;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.starl.id.ProcessId;
import org.starl.primitives.agreement.SynodCodec;
import org.starl.primitives.agreement.Value;
import org.starl.shape.WireFormatException;
import org.starl.shape.WireReader;

/** {@link Outcomes} as a value of the Synod. The bytes are in {@code docs/wire-format.md}. */
final class OutcomesFormat implements SynodCodec.Format {

  // At worst, each member is excluded by a generation of its own.
  private static final int BYTES_PER_MEMBER = Long.BYTES + 2 * Short.BYTES;

  private final List<ProcessId> first;

  /**
   * @param first the members of generation 1; values name them by their positions
   */
  OutcomesFormat(SortedSet<ProcessId> first) {
    if (Short.BYTES + first.size() * BYTES_PER_MEMBER > Value.MAX_BYTES) {
      throw new IllegalArgumentException(
          "a barrier of " + first.size() + " members: too many for one message");
    }
    this.first = List.copyOf(first);
  }

  @Override
  public void checkValue(long number, Value value) {
    read(value);
  }

  Value toValue(Outcomes outcomes) {
    return Value.write(out -> {
      out.u16(outcomes.missing().size());
      outcomes
          .missing()
          .forEach((generation, ids) -> {
            out.i64(generation);
            out.u16(ids.size());
            ids.forEach(id -> out.u16(first.indexOf(id)));
          });
    });
  }

  /** Throws {@link WireFormatException} on what {@link #toValue} cannot have written. */
  Outcomes read(Value value) {
    return value.read("outcomes", this::outcomes);
  }

  private Outcomes outcomes(WireReader in) {
    SortedMap<Long, SortedSet<ProcessId>> missing = new TreeMap<>();
    int count = in.u16();
    SortedSet<ProcessId> excluded = new TreeSet<>();
    for (int i = 0; i < count; i++) {
      long generation = in.i64(1, "generation");
      SortedSet<ProcessId> ids = new TreeSet<>();
      int absent = in.u16();
      for (int j = 0; j < absent; j++) {
        ProcessId id = member(in.u16());
        boolean isNext = ids.isEmpty() || ids.last().compareTo(id) < 0;
        if (!isNext || !excluded.add(id)) {
          throw new WireFormatException(id + " is missing twice, or out of order");
        }
        ids.add(id);
      }
      if (ids.isEmpty() || (!missing.isEmpty() && missing.lastKey() >= generation)) {
        throw new WireFormatException("failed generation " + generation);
      }
      missing.put(generation, ids);
    }
    return new Outcomes(missing);
  }

  private ProcessId member(int place) {
    if (place >= first.size()) {
      throw new WireFormatException("member " + place + " of " + first.size());
    }
    return first.get(place);
  }
}
