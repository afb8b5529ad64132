package org.starl.lang.java;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.starl.lang.read.SourceErrors;

/** Names of Java that a source gives, and numbers: its Java compiles, or the source is refused. */
class NamesTest {

  private static final String HEAD =
      """
      automaton Own[P]
      java "x.XAutomaton"
      java P = "Integer"
      type Integer = small | big
      type Rec = record(of: option[P])
      state
        size: Integer
        all: set[P]
        n: nat
      start size = small, all = {}, n = 12345678901
      action Rec(x: P)
        pre n < 99999999999, n != 5000000000
        eff size := big, all := all union {x}, n := n + 3000000000
      """;

  @Test
  void classMayHaveTheNameOfATypeOfTheSource() throws SourceErrors {
    assertThat(new Compiled(HEAD).step("Rec", 7))
        .isEqualTo("States[size=big, all=[7], n=15345678901]");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '~',
      textBlock =
          """
          "Integer"        ~ "int"               ~ 'int' is no class; expected one that has no parameters, as in: java P = "String"
          "Integer"        ~ "java.util.Set<P>"  ~ 'java.util.Set<P>' is no class; expected one that has no parameters, as in: java P = "String"
          x.X              ~ int.X               ~ 'int.XAutomaton' is no Java class of an automaton; expected a line: java "a.package.NameAutomaton"
          n: nat           ~ n: nat m: [option[P] -> nat] ~ in Java a map has no arguments of type option[P]; expected numbers, an opaque type, a record or a type of forms
          n: nat           ~ n: nat m: map[set[P], nat] ~ in Java a map has no arguments of type set[P]; expected numbers, an opaque type, a record or a type of forms
          """)
  void whatJavaWouldNotCompileIsRefused(String part, String wrong, String told) {
    assertThatThrownBy(() -> Compiled.files(HEAD.replace(part, wrong)))
        .hasMessage("x.starl:1:1: " + told);
  }

  @Test
  void eachAutomatonHasItsClass() {
    String other =
        "automaton Other java \"x.XAutomaton\" state b: bool start b action z eff b := b";
    assertThatThrownBy(() -> Compiled.files(HEAD + other))
        .hasMessage(
            "x.starl:14:1: 'x.XAutomaton' is the Java class of 'Own' already; expected another one");
  }
}
