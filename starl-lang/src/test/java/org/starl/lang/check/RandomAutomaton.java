package org.starl.lang.check;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/** Writes sources of small automata. */
final class RandomAutomaton {

  private final Random random;

  /** The one of m, l and z that changes: with all of them there would be too many states. */
  private String changing = "m";

  RandomAutomaton(Random random) {
    this.random = random;
  }

  /** Its components are a set, a number, an option, a map, a list and an int; its actions have an id, or a number. */
  String source() {
    changing = pick(List.of("m", "m", "l", "z"));
    StringBuilder text =
        new StringBuilder(
            """
            automaton Random[PIDS]
            state
              s: set[PIDS]
              n: nat
              o: option[PIDS]
              m: [PIDS -> set[PIDS]]
              l: list[PIDS]
              z: int
            """);
    text.append("start n = 0, l = [], z = 0");
    text.append(random.nextInt(4) > 0 ? ", s = {}" : "");
    text.append(random.nextInt(4) > 0 ? ", o = none" : "");
    text.append(", forall k: PIDS :: m(k) = {}\n");
    int actions = 2 + random.nextInt(3);
    for (int i = 0; i < actions; i++) {
      boolean isOfId = random.nextInt(4) > 0;
      text.append("action a%d(%s)\n".formatted(i, isOfId ? "i: PIDS, j: PIDS" : "c: nat"));
      List<String> ids = isOfId ? List.of("i", "j") : List.of();
      List<String> nats = isOfId ? List.of("n") : List.of("n", "c");
      text.append("  pre ").append(bool(2, ids, nats)).append(" or ").append(bool(1, ids, nats));
      text.append(", ").append(bool(0, ids, nats)).append(" or ").append(bool(1, ids, nats));
      text.append("\n  eff ").append(String.join(", ", effects(ids, nats))).append('\n');
    }
    text.append("invariant Inv: ").append(bool(3, List.of(), List.of("n"))).append(" or ");
    text.append(bool(2, List.of(), List.of("n"))).append('\n');
    return text.toString();
  }

  /** One of two has a constraint. */
  String constrained() {
    String source = source();
    return random.nextBoolean()
        ? source + "constraint C: " + bool(2, List.of(), List.of("n")) + "\n"
        : source;
  }

  private List<String> effects(List<String> ids, List<String> nats) {
    List<String> all = new ArrayList<>();
    if (random.nextBoolean()) {
      all.add("s := " + set(1, ids, nats));
    }
    if (random.nextBoolean()) {
      all.add("n := " + nat(ids, nats));
    }
    if (!ids.isEmpty() && random.nextBoolean()) {
      all.add("o := " + (random.nextInt(3) > 0 ? "some(" + pick(ids) + ")" : "none"));
    }
    if (!ids.isEmpty() && changing.equals("m") && (all.isEmpty() || random.nextBoolean())) {
      all.add("m(" + pick(ids) + ") := " + set(1, ids, nats));
    }
    if (!ids.isEmpty() && changing.equals("l") && random.nextBoolean()) {
      all.add("l := " + (random.nextInt(3) > 0 ? "l ++ [" + pick(ids) + "]" : "[]"));
    }
    if (changing.equals("z") && random.nextBoolean()) {
      all.add("z := " + pick(List.of("z - 1", "n - 2", "-z", "z + n")));
    }
    return all.isEmpty() ? List.of("n := n + 1") : all;
  }

  private <T> T pick(List<T> from) {
    return from.get(random.nextInt(from.size()));
  }

  private String id(List<String> ids) {
    // An operation that may have no value is rare: else few runs would go beyond it.
    return ids.isEmpty() || random.nextInt(30) == 0
        ? (random.nextBoolean() ? "the(o)" : "l(n)")
        : pick(ids);
  }

  private String nat(List<String> ids, List<String> nats) {
    return switch (random.nextInt(8)) {
      case 7 -> "card(" + set(1, ids, nats) + ")";
      case 0 -> "0";
      case 1 -> "1";
      case 6 -> "length(l)";
      case 2 -> pick(nats) + " + 1";
      case 3 -> "(if " + bool(1, ids, nats) + " then " + pick(nats) + " else 2)";
      case 4 -> random.nextInt(5) == 0 ? "n - 1" : pick(nats);
      default -> pick(nats);
    };
  }

  private String set(int depth, List<String> ids, List<String> nats) {
    int kind = random.nextInt(ids.isEmpty() ? 4 : 7);
    return switch (depth == 0 ? kind % 2 : kind) {
      case 0 -> "s";
      case 1 -> ids.isEmpty() ? "s" : "m(" + pick(ids) + ")";
      case 2 -> "(" + set(depth - 1, ids, nats) + " union " + set(depth - 1, ids, nats) + ")";
      case 3 -> "{k: PIDS | " + bool(depth - 1, plus(ids, "k"), nats) + "}";
      case 4 -> "(" + set(depth - 1, ids, nats) + " minus {" + pick(ids) + "})";
      default -> "(" + set(depth - 1, ids, nats) + " union {" + pick(ids) + "})";
    };
  }

  private static List<String> plus(List<String> ids, String id) {
    List<String> more = new ArrayList<>(ids);
    more.add(id);
    return more;
  }

  private String bool(int depth, List<String> ids, List<String> nats) {
    if (depth == 0) {
      return switch (random.nextInt(8)) {
        case 6 -> "z < n"; // c may be beyond the bound, where the plain meaning has none
        case 7 -> "n - 2 = z";
        case 0 -> "o = none";
        case 1 -> pick(nats) + " < 2";
        case 2 -> pick(nats) + " != 0";
        case 3 -> ids.isEmpty() ? "s = {}" : pick(ids) + " in s";
        case 4 -> ids.isEmpty() ? "n < 1" : id(ids) + " = " + pick(ids);
        default -> ids.isEmpty() ? "true" : pick(ids) + " in m(" + id(ids) + ")";
      };
    }
    String bound = "q" + depth;
    return switch (random.nextInt(8)) {
      case 0 -> "not (" + bool(depth - 1, ids, nats) + ")";
      case 1 -> "(" + bool(depth - 1, ids, nats) + " and " + bool(depth - 1, ids, nats) + ")";
      case 2 -> "(" + bool(depth - 1, ids, nats) + " or " + bool(depth - 1, ids, nats) + ")";
      case 3 -> "(" + bool(depth - 1, ids, nats) + " => " + bool(depth - 1, ids, nats) + ")";
      case 4 -> "(forall " + bound + ": PIDS :: " + bool(depth - 1, plus(ids, bound), nats) + ")";
      case 5 -> "(exists " + bound + ": PIDS :: " + bool(depth - 1, plus(ids, bound), nats) + ")";
      case 6 -> "(" + set(1, ids, nats) + " subset " + set(0, ids, nats) + ")";
      default -> bool(0, ids, nats);
    };
  }
}
