package org.starl.lang.prove;

import java.math.BigDecimal;
import java.util.List;
import java.util.stream.Collectors;

/** Texts of SMT-LIB 2. */
final class Smt {

  static final String TRUE = "true";
  static final String FALSE = "false";

  private Smt() {}

  static String call(String function, List<String> arguments) {
    return arguments.isEmpty()
        ? function
        : "(" + function + " " + String.join(" ", arguments) + ")";
  }

  static String call(String function, String... arguments) {
    return call(function, List.of(arguments));
  }

  static String and(List<String> parts) {
    return join("and", TRUE, FALSE, parts);
  }

  static String or(List<String> parts) {
    return join("or", FALSE, TRUE, parts);
  }

  /** {@code neutral} changes nothing, {@code decisive} decides. */
  private static String join(String operator, String neutral, String decisive, List<String> parts) {
    if (parts.contains(decisive)) {
      return decisive;
    }
    List<String> left = parts.stream().filter(part -> !part.equals(neutral)).distinct().toList();
    return switch (left.size()) {
      case 0 -> neutral;
      case 1 -> left.getFirst();
      default -> call(operator, left);
    };
  }

  static boolean isQuantified(String condition) {
    return condition.contains("(forall") || condition.contains("(exists");
  }

  static String not(String a) {
    return a.equals(TRUE) ? FALSE : a.equals(FALSE) ? TRUE : call("not", a);
  }

  static String implies(String a, String b) {
    return a.equals(TRUE) ? b : a.equals(FALSE) || b.equals(TRUE) ? TRUE : call("=>", a, b);
  }

  static String equal(String a, String b) {
    return a.equals(b) ? TRUE : call("=", a, b);
  }

  static String ite(String condition, String then, String otherwise) {
    if (condition.equals(TRUE) || then.equals(otherwise)) {
      return then;
    }
    return condition.equals(FALSE) ? otherwise : call("ite", condition, then, otherwise);
  }

  /** A bound variable. */
  record Binding(String name, String sort) {

    static List<String> names(List<Binding> bindings) {
      return bindings.stream().map(Binding::name).toList();
    }

    /** {@code ((i PIDS) (n Int))}. */
    static String text(List<Binding> bindings) {
      return bindings.stream()
          .map(each -> "(" + each.name + " " + each.sort + ")")
          .collect(Collectors.joining(" ", "(", ")"));
    }
  }

  static String quantified(boolean forAll, List<Binding> bindings, String body) {
    if (bindings.isEmpty() || body.equals(TRUE) || body.equals(FALSE)) {
      return body; // no type is empty
    }
    return call(forAll ? "forall" : "exists", Binding.text(bindings), body);
  }

  static String number(BigDecimal value, boolean isReal) {
    String text = value.toPlainString();
    return !isReal ? value.toBigInteger().toString() : text.contains(".") ? text : text + ".0";
  }
}
