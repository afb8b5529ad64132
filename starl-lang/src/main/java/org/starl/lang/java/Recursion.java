package org.starl.lang.java;

import org.starl.lang.tree.Expr;
import org.starl.lang.tree.Exprs;
import org.starl.lang.tree.Function;
import org.starl.lang.tree.Type;

/** Writes a function of g that calls itself with g - 1 alone as a loop: a run may be long. */
final class Recursion {

  private Recursion() {}

  static boolean isCounted(Function f) {
    return f.measure().isPresent()
        && f.signature().parameters().size() == 1
        && f.measure().get() instanceof Expr.Variable
        && f.signature().parameters().getFirst().type().base() == Type.Num.NAT
        && callsBefore(f.body(), f);
  }

  private static boolean callsBefore(Expr at, Function f) {
    if (calls(at, f)) {
      return ((Expr.Call) at).arguments().getFirst() instanceof Expr.Binary e
          && e.operator() == Expr.Operator.LESS_BY
          && isParameter(e.left(), f)
          && e.right() instanceof Expr.Numeral one
          && one.value().intValue() == 1;
    }
    return Exprs.parts(at).stream().allMatch(part -> callsBefore(part, f));
  }

  private static boolean calls(Expr at, Function f) {
    return at instanceof Expr.Call call && call.function().name().equals(f.signature().name());
  }

  private static boolean isParameter(Expr at, Function f) {
    return at instanceof Expr.Variable v
        && v.name().equals(f.signature().parameters().getFirst().name());
  }

  static void write(int indent, Function f, ExpressionWriter writer, JavaText out) {
    String last = JavaTypes.variable(f.signature().parameters().getFirst().name());
    String each = last + "_";
    JavaTypes types = writer.types();
    String type = types.of(f.signature().result(), f.pos());
    writer.bind(f.signature().parameters().getFirst().name(), Code.name(each));
    writer.bind("value_", Code.name("value"));
    Code next = writer.of(earlier(f.body(), f));
    Layout first = new Layout().token(type + " value =").open(4).brk(" ");
    types.any(f.signature().result(), f.pos()).write(first);
    out.add(indent, first.token(";").close());
    out.line(indent, "for (long " + each + " = 0; " + each + " <= " + last + "; " + each + "++) {");
    Layout step = new Layout().token("value =").open(4).brk(" ");
    next.write(step);
    out.add(indent + 2, step.token(";").close());
    out.line(indent, "}").line(indent, "return value;");
  }

  /** The calls are the value of the round before. */
  private static Expr earlier(Expr at, Function f) {
    return calls(at, f)
        ? new Expr.Variable("value_", f.signature().result(), at.pos())
        : Exprs.rebuild(at, part -> earlier(part, f));
  }
}
