package org.starl.lang.read;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.starl.lang.tree.Expr;
import org.starl.lang.tree.Expr.Operator;
import org.starl.lang.tree.Primitive;
import org.starl.lang.tree.Program.Instance;

/** What guards of branches are made of. */
final class Guards {

  private Guards() {}

  /** An outcome of an instance. */
  record Happened(String instance, Primitive.Outcome outcome) {}

  /** The outcome that {@code expr} is: {@code mux.failed}. */
  static Optional<Happened> outcome(Expr expr, Map<String, Instance> instances) {
    if (expr instanceof Expr.Get get && get.of() instanceof Expr.Component component) {
      return Optional.ofNullable(instances.get(component.name()))
          .flatMap(instance -> instance.primitive().outcome(get.field()))
          .map(found -> new Happened(component.name(), found));
    }
    return Optional.empty();
  }

  /** What holds if {@code guard} does, each for itself. */
  static List<Expr> conjuncts(Expr guard) {
    if (guard instanceof Expr.Binary both && both.operator() == Operator.AND) {
      List<Expr> all = new ArrayList<>(conjuncts(both.left()));
      all.addAll(conjuncts(both.right()));
      return all;
    }
    return guard instanceof Expr.Bool always && always.value() ? List.of() : List.of(guard);
  }
}
