package org.starl.lang.java;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.function.Function;
import org.starl.lang.tree.Expr;
import org.starl.lang.tree.Type;

/** Makes {@code c1 ? a : c2 ? b : c} of a match: the last case has no condition. */
final class Choices {

  private Choices() {}

  static Code of(Expr.Match at, ExpressionWriter writer, Function<Expr, Code> value) {
    Type.Sum sum = (Type.Sum) at.of().type().base();
    Code of = writer.of(at.of());
    List<Expr.Case> cases = new ArrayList<>(at.cases());
    // The last one needs no variable if it has no fields.
    cases.stream()
        .filter(each -> each.variables().isEmpty())
        .reduce((a, b) -> b)
        .ifPresent(last -> {
          cases.remove(last);
          cases.add(last);
        });
    Code whole = null;
    for (Expr.Case each : cases.reversed()) {
      String type = writer.types().of(sum, at.pos());
      String constructor = JavaTypes.form(sum, each.constructor().name());
      boolean isLast = whole == null;
      boolean hasVariable = !isLast && !each.variables().isEmpty();
      Code cast =
          hasVariable
              ? Code.name(constructor + "_")
              : new Code.Prefix("(" + type + "." + constructor + ") ", of);
      for (int i = 0; i < each.variables().size(); i++) {
        String field = each.constructor().fields().get(i).name();
        writer.bind(each.variables().get(i).name(), cast.then(JavaTypes.name(field)));
      }
      Code then = value.apply(each.value());
      if (whole == null) {
        whole = then;
      } else {
        Code condition =
            hasVariable
                ? new Code.InstanceOf(of, type + "." + constructor + " " + constructor + "_")
                : writer.is(of, sum, each.constructor(), at.pos());
        whole = Code.choice(condition, then, whole);
      }
    }
    return Objects.requireNonNull(whole);
  }
}
