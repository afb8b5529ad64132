package org.starl.lang.java;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/**
 * Writes well-typed actions at random, over a state of every type. None is without a value: partial
 * operations stand behind a test.
 */
final class RandomSource {

  /** What stands before the actions. The start leaves nothing open. */
  static final String HEAD =
      """
      automaton Random_decls[T]
      java "x.XAutomaton"
      type Mode = low | high
      type Phase = idle | busy | failed(who: T, times: nat)
      type Entry = record(gen: nat, owner: option[T], mode: Mode)
      state
        flag: bool
        n: nat
        those: set[T]
        m: [T -> nat]
        g: [T -> set[T]]
        e: Entry
        r: [T -> Entry]
        p: Phase
        q: list[T]
        z: int
        v: [T -> int]
      start flag = false, n = 1, those = {}, forall t: T :: m(t) = 0, forall t: T :: g(t) = {},
        e.gen = 0, e.owner = none, e.mode = low, p = idle, q = [],
        z = 0, forall t: T :: v(t) = -1,
        forall t: T :: r(t).gen = 1 and r(t).owner = none and r(t).mode = high
      """;

  /** The variables in scope. */
  private record Scope(List<String> ids, List<String> nats) {
    Scope withId(String id) {
      List<String> more = new ArrayList<>(ids);
      more.add(id);
      return new Scope(more, nats);
    }

    Scope withNat(String nat) {
      List<String> more = new ArrayList<>(nats);
      more.add(nat);
      return new Scope(ids, more);
    }
  }

  private final Random random;
  private int bound;

  RandomSource(Random random) {
    this.random = random;
  }

  /** An action of two ids and a number. */
  String action(String name) {
    bound = 0;
    Scope scope = new Scope(List.of("i", "j"), List.of("c"));
    List<String> pre = new ArrayList<>();
    for (int n = random.nextInt(3); n >= 0; n--) {
      pre.add(bool(2, scope) + (random.nextBoolean() ? " or " + bool(1, scope) : ""));
    }
    List<String> eff = effects(scope);
    if (eff.stream().anyMatch(each -> each.startsWith("g(j)"))) {
      pre.add("i != j"); // else one place changes twice
    }
    return "action %s(i: T, j: T, c: nat)\n  pre %s\n  eff %s\n"
        .formatted(name, String.join(", ", pre), String.join(", ", eff));
  }

  private List<String> effects(Scope scope) {
    List<String> all = new ArrayList<>();
    List<Runnable> kinds =
        List.of(
            () -> all.add("flag := " + bool(1, scope)),
            () -> all.add("n := " + nat(2, scope)),
            () -> all.add("those := " + set(2, scope)),
            () -> all.add("m(" + id(1, scope) + ") := " + nat(1, scope)),
            () -> {
              all.add("g(i) := " + set(1, scope));
              all.add("g(j) := " + set(1, scope));
            },
            () -> all.add("e := " + entry(1, scope)),
            () -> {
              all.add("e.gen := " + nat(1, scope));
              all.add("e.owner := " + option(scope));
            },
            () -> all.add("r(i).owner := " + option(scope)),
            () -> all.add("r(" + id(1, scope) + ") := " + entry(1, scope)),
            () -> all.add("p := " + phase(scope)),
            () -> all.add("q := " + list(scope)),
            () -> all.add("z := " + integer(scope)),
            () -> all.add("v(" + id(1, scope) + ") := " + integer(scope)));
    boolean hasEntry = false;
    boolean hasRow = false;
    for (int kind = 0; kind < kinds.size(); kind++) {
      boolean isTaken = (kind == 6 && hasEntry) || (kind == 8 && hasRow);
      if (!isTaken && random.nextInt(4) == 0) {
        kinds.get(kind).run();
        hasEntry |= kind == 5;
        hasRow |= kind == 7;
      }
    }
    return all.isEmpty() ? List.of("n := " + nat(2, scope)) : all;
  }

  private <T> T pick(List<T> from) {
    return from.get(random.nextInt(from.size()));
  }

  private String id(int depth, Scope scope) {
    return switch (depth == 0 ? 9 : random.nextInt(13)) {
      case 0 -> "(if q = [] then " + id(0, scope) + " else head(q))";
      case 1 -> "(if e.owner = none then " + id(0, scope) + " else the(e.owner))";
      case 2 -> "(match p { idle -> " + id(0, scope) + ", busy -> i, failed(w, k) -> w })";
      case 3 -> "(if " + bool(0, scope) + " then " + id(0, scope) + " else j)";
      case 4 -> "(if n < length(q) then q(n) else " + id(0, scope) + ")";
      default -> pick(scope.ids);
    };
  }

  private String nat(int depth, Scope scope) {
    if (depth == 0) {
      return switch (random.nextInt(8)) {
        case 7 -> random.nextBoolean() ? "length(q)" : "card(those)";
        case 0 -> "n";
        case 1 -> "m(" + pick(scope.ids) + ")";
        case 2 -> "e.gen";
        case 3 -> "r(" + pick(scope.ids) + ").gen";
        case 4 -> String.valueOf(random.nextInt(3));
        default -> pick(scope.nats);
      };
    }
    String left = nat(depth - 1, scope);
    String right = nat(0, scope);
    return switch (random.nextInt(7)) {
      case 0 -> "(" + left + " + " + right + ")";
      case 1 -> "(if " + left + " < " + right + " then " + right + " - " + left + " else 0)";
      case 2 -> "(if " + bool(1, scope) + " then " + left + " else " + right + ")";
      case 3 -> "(match p { idle -> 0, busy -> " + left + ", failed(w, k) -> k })";
      case 4 -> "(" + nat(0, scope) + " * " + right + ")";
      default -> left;
    };
  }

  private String integer(Scope scope) {
    String nat = nat(0, scope);
    return switch (random.nextInt(6)) {
      case 0 -> "-z";
      case 1 -> "(" + nat + " - " + nat(0, scope) + ")";
      case 2 -> "(z - " + nat + ")";
      case 3 -> "(v(" + id(0, scope) + ") + " + nat + ")";
      case 4 -> "(if " + bool(0, scope) + " then v(i) else -" + nat + ")";
      default -> nat;
    };
  }

  private String set(int depth, Scope scope) {
    String set = depth == 0 ? "" : set(depth - 1, scope);
    return switch (depth == 0 ? random.nextInt(5) : random.nextInt(10)) {
      case 0 -> "those";
      case 1 -> "g(" + id(0, scope) + ")";
      case 2 -> "{" + id(0, scope) + "}";
      case 3 -> "elements(q)";
      case 4 -> "({i} minus {j})";
      case 5 -> "(" + set + " union " + set(0, scope) + ")";
      case 6 -> "(" + set + " intersect " + set(0, scope) + ")";
      case 7 -> "(" + set + " minus " + set(0, scope) + ")";
      case 8 -> {
        String x = "x" + bound++;
        yield "{%s: T | %s in %s and %s}".formatted(x, x, set, bool(0, scope.withId(x)));
      }
      default -> "{" + id(0, scope) + ", " + id(1, scope) + "}";
    };
  }

  private String option(Scope scope) {
    return switch (random.nextInt(4)) {
      case 0 -> "none";
      case 1 -> "r(" + id(0, scope) + ").owner";
      default -> "some(" + id(1, scope) + ")";
    };
  }

  private String mode(Scope scope) {
    return switch (random.nextInt(4)) {
      case 0 -> "low";
      case 1 -> "high";
      case 2 -> "r(" + id(0, scope) + ").mode";
      default -> "(if " + bool(0, scope) + " then low else e.mode)";
    };
  }

  private String entry(int depth, Scope scope) {
    return switch (depth == 0 ? random.nextInt(2) : random.nextInt(5)) {
      case 0 -> "e";
      case 1 -> "r(" + id(0, scope) + ")";
      case 2 -> "(if " + bool(1, scope) + " then e else " + entry(0, scope) + ")";
      default ->
          "Entry(gen := %s, owner := %s, mode := %s)"
              .formatted(nat(1, scope), option(scope), mode(scope));
    };
  }

  private String phase(Scope scope) {
    return switch (random.nextInt(5)) {
      case 0 -> "idle";
      case 1 -> "busy";
      case 2 -> "(match p { idle -> busy, busy -> idle, failed(w, k) -> failed(i, k + 1) })";
      default -> "failed(" + id(1, scope) + ", " + nat(1, scope) + ")";
    };
  }

  private String list(Scope scope) {
    return switch (random.nextInt(7)) {
      case 5 -> "(q ++ [" + id(0, scope) + "])";
      case 6 -> "([i] ++ q)";
      case 0 -> "[]";
      case 1 -> "(if q = [] then [i] else tail(q))";
      case 2 -> "(if " + bool(0, scope) + " then q else [j])";
      default -> "[" + id(0, scope) + ", " + id(1, scope) + "]";
    };
  }

  private String bool(int depth, Scope scope) {
    if (depth == 0) {
      return switch (random.nextInt(14)) {
        case 12 -> "z" + pick(List.of(" < ", " >= ", " = ")) + integer(scope);
        case 13 -> integer(scope) + pick(List.of(" != ", " = ")) + "v(" + id(0, scope) + ")";
        case 0 -> "flag";
        case 1 -> nat(0, scope) + pick(List.of(" < ", " <= ", " = ", " != ")) + nat(0, scope);
        case 2 -> id(0, scope) + " = " + id(0, scope);
        case 3 -> "r(" + id(0, scope) + ").owner = " + pick(List.of("none", "e.owner", "some(i)"));
        case 4 -> "p is " + pick(List.of("idle", "busy", "failed"));
        case 5 -> "r(" + id(0, scope) + ").mode = " + pick(List.of("low", "high", "e.mode"));
        case 6 -> "q " + pick(List.of("= []", "!= []", "= [i]"));
        case 7 -> "distinct(q)";
        case 8 -> "r(" + id(0, scope) + ") = e";
        case 9 -> "p = " + pick(List.of("idle", "failed(j, 1)"));
        default -> id(0, scope) + " in " + set(0, scope);
      };
    }
    String left = bool(depth - 1, scope);
    return switch (random.nextInt(12)) {
      case 0 -> "not (" + left + ")";
      case 1 -> "(" + left + " and " + bool(depth - 1, scope) + ")";
      case 2 -> "(" + left + " or " + bool(depth - 1, scope) + ")";
      case 3 -> "(" + left + " => " + bool(depth - 1, scope) + ")";
      case 4 -> "(" + left + " <=> " + bool(depth - 1, scope) + ")";
      case 5 ->
          "("
              + set(1, scope)
              + pick(List.of(" subset ", " disjoint ", " = "))
              + set(0, scope)
              + ")";
      case 6 -> "(match p { idle -> " + left + ", busy -> flag, failed(w, k) -> w = i or k < n })";
      case 7 -> "(if " + left + " then " + bool(0, scope) + " else " + bool(0, scope) + ")";
      case 8, 9 -> {
        String x = "x" + bound++;
        String all = random.nextBoolean() ? "forall" : "exists";
        yield "(%s %s: T :: %s)".formatted(all, x, bool(depth - 1, scope.withId(x)));
      }
      case 10 -> {
        String k = "k" + bound++;
        String body = bool(0, scope.withNat(k));
        yield random.nextBoolean()
            ? "(forall %s: nat :: %s < n => %s)".formatted(k, k, body)
            : "(exists %s: nat :: %s <= n and %s)".formatted(k, k, body);
      }
      default -> left;
    };
  }
}
