package org.starl.lang.check;

import java.io.DataInput;
import java.io.DataOutput;
import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.starl.lang.tree.Action;

/** What a search has counted besides the states. */
final class Counts {

  long steps;
  long beyond;
  long beyondArguments;

  /** The states in which a constraint is false. */
  int outside;

  /** Of each action, how often it was taken. */
  final long[] taken;

  /** Of each action, the conjuncts that were false somewhere. */
  final boolean[][] falses;

  /** The conditions that were beyond the bounds in some states, with the number of these. */
  final Map<String, Long> unevaluated = new LinkedHashMap<>();

  Counts(List<Action> actions) {
    taken = new long[actions.size()];
    falses = new boolean[taken.length][];
    for (int i = 0; i < taken.length; i++) {
      falses[i] = new boolean[actions.get(i).pre().size()];
    }
  }

  void set(Counts other) {
    steps = other.steps;
    beyond = other.beyond;
    beyondArguments = other.beyondArguments;
    outside = other.outside;
    System.arraycopy(other.taken, 0, taken, 0, taken.length);
    for (int i = 0; i < falses.length; i++) {
      System.arraycopy(other.falses[i], 0, falses[i], 0, falses[i].length);
    }
    unevaluated.clear();
    unevaluated.putAll(other.unevaluated);
  }

  void write(DataOutput out) throws IOException {
    out.writeLong(steps);
    out.writeLong(beyond);
    out.writeLong(beyondArguments);
    out.writeInt(outside);
    for (int i = 0; i < taken.length; i++) {
      out.writeLong(taken[i]);
      for (boolean isFalse : falses[i]) {
        out.writeBoolean(isFalse);
      }
    }
    out.writeInt(unevaluated.size());
    for (Map.Entry<String, Long> each : unevaluated.entrySet()) {
      out.writeUTF(each.getKey());
      out.writeLong(each.getValue());
    }
  }

  void read(DataInput in) throws IOException {
    steps = in.readLong();
    beyond = in.readLong();
    beyondArguments = in.readLong();
    outside = in.readInt();
    for (int i = 0; i < taken.length; i++) {
      taken[i] = in.readLong();
      for (int c = 0; c < falses[i].length; c++) {
        falses[i][c] = in.readBoolean();
      }
    }
    unevaluated.clear();
    for (int left = in.readInt(); left > 0; left--) {
      unevaluated.put(in.readUTF(), in.readLong());
    }
  }
}
