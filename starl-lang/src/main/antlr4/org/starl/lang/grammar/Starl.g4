// The grammar of .starl files. The meaning is in docs/language.md; names and types are checked by
// org.starl.lang.read.
grammar Starl;

file: (unit | program | primitive)* EOF;

unit: AUTOMATON name=id parameters? part*;

parameters: '[' parameter (',' parameter)* ']';

parameter
    : name=id               # typeParameter
    | name=id ':' type      # valueParameter
    ;

part
    : TYPE name=id '=' typeBody                                     # typePart
    | ASSUME name=id ':' expression                                  # assumePart
    | ASSUME? PROGRESS name=id ':' formula                          # progressPart
    | STATE component+                                              # statePart
    | USES name=id ':' of=id ('[' argument (',' argument)* ']')?    # usesPart
    | REFINES name=id ':' of=id ('[' argument (',' argument)* ']')? BY mapping (',' mapping)*   # refinesPart
    | FUN name=id binders? ':' type '=' expression measure?         # funPart
    | START expression (',' expression)*                            # startPart
    | ACTION name=id binders? fairness? pre? eff?                   # actionPart
    | INVARIANT name=id ':' expression                              # invariantPart
    | CONSTRAINT name=id ':' expression                             # constraintPart
    | JAVA STRING                                                   # javaClassPart
    | JAVA type '=' of=STRING (START first=STRING)?                 # javaTypePart
    ;

component: name=id ':' type;

argument: type;

binders: '(' binderGroup (',' binderGroup)* ')';

binderGroup: id (',' id)* ':' type;

measure: MEASURE expression;

// Each instance of the action is fair; with 'as', all actions that are fair under this name together.
fairness: STRONGLY? FAIR (AS group=id)? (FOR each+=id (',' each+=id)*)?;

formula
    : FORALL binderGroup (',' binderGroup)* '::' formula            # allOf
    | EVENTUALLY to=expression                                      # eventually
    | from=expression LEADS TO to=expression                        # leadsTo
    | NO DEADLOCK (UNLESS to=expression)?                           # noDeadlock
    ;

pre: PRE expression (',' expression)*;

eff: EFF effect (',' effect)*;

effect
    : place ':=' expression                                         # assignment
    | (IF condition=expression THEN)? used=id '.' action=id '(' arguments? ')'    # usedAction
    ;

arguments: expression (',' expression)*;

mapping
    : name=id ('.' path+=id)* ':=' expression                       # mapped
    | action=id ('(' own+=id (',' own+=id)* ')')? IS step    # stepOf
    ;

step
    : NOTHING                                                       # noStep
    | action=id ('(' arguments? ')')?                               # oneStep
    | IF expression THEN step (ELSE step)?                          # stepIf
    ;

place: name=id selector*;

selector
    : '(' expression (',' expression)* ')'      # at
    | '.' name=id                               # field
    ;

program: PROGRAM name=id parameters? programPart*;

programPart
    : GIVEN given (',' given)*                                      # givenPart
    | USES name=id ':' of=id ('(' (expression (',' expression)*)? ')')?    # instancePart
    | JAVA FUN name=id binders? ':' type '=' of=STRING              # javaFunPart
    | STATE variable+                                               # variablesPart
    | EVERY NUMBER unitOfTime=id                                    # everyPart
    | LOCATION name=id branch*                                      # locationPart
    | part                                                          # otherPart
    ;

given: name=id ':' type;

variable: name=id ':' type (':=' expression)?;

branch: (WHEN expression)? DO statement (';' statement)*;

statement
    : GOTO to=id                                                    # goto
    | RESTART                                                       # restart
    | used=id '.' name=id '(' (expression (',' expression)*)? ')'   # call
    | name=id ':=' expression                                       # assign
    ;

// The face of a primitive to programs, and the automaton behind it.
primitive: PRIMITIVE name=id binders? IS of=id face*;

face
    : JAVA of=STRING '=' made=STRING                        # javaFace
    | ACTION name=id binders? pre? '=' usedStep JAVA of=STRING    # callFace
    | FUN name=id ':' type '=' expression JAVA of=STRING    # valueFace
    | WHEN name=id '=' usedStep JAVA of=STRING              # outcomeFace
    | DO id (',' id)* fairness?                             # stepsFace
    | ASSUME PROGRESS name=id ':' formula                   # assumedFace
    | START expression                                      # startFace
    | RESTART expression                                    # restFace
    ;

usedStep: action=id '(' (expression (',' expression)*)? ')';

typeBody
    : RECORD '(' binderGroup (',' binderGroup)* ')'    # recordBody
    | constructor ('|' constructor)+                   # sumBody
    | type                                             # aliasBody
    ;

constructor: name=id ('(' binderGroup (',' binderGroup)* ')')?;

type
    : SET '[' type ']'                          # setType
    | LIST '[' type ']'                         # listType
    | OPTION '[' type ']'                       # optionType
    | '[' type (',' type)* '->' type ']'        # mapType
    | MAP '[' type (',' | arrow='->') type ']'    # partialMapType
    | bound '..' bound                          # rangeType
    | name=id                                   # namedType
    ;

// What may not be in it is told by what it is.
bound: negative='-'? product (sign product)*;

sign: '+' | '-';

product: factor ('*' factor)*;

factor: NUMBER | id | '(' bound ')';

expression
    : expression '.' name=id                                            # fieldOf
    | expression '(' (expression (',' expression)*)? ')'                # apply
    | '-' expression                                                    # negative
    | expression op=('*' | '/' | MOD) expression                        # multiplication
    | expression op=('+' | '++' | '-' | UNION | MINUS | INTERSECT) expression  # sum
    | expression '..' expression                                        # range
    | expression op=('=' | '!=' | '<' | '<=' | '>' | '>=' | IN | SUBSET | DISJOINT) expression # comparison
    | expression IS name=id                                             # isOf
    | NOT expression                                                    # not
    | expression AND expression                                         # and
    | expression OR expression                                          # or
    | <assoc=right> expression '=>' expression                          # implies
    | expression '<=>' expression                                       # iff
    | quantifier=(FORALL | EXISTS) binderGroup (',' binderGroup)* '::' expression    # quantified
    | LET name=id '=' expression '::' expression                        # let
    | CHOOSE name=id ':' type '::' expression                           # choose
    | IF expression THEN expression ELSE expression                     # conditional
    | MATCH expression '{' matchCase (',' matchCase)* '}'               # match
    | '{' name=id ':' type '|' expression '}'                           # comprehension
    | '{' (expression (',' expression)*)? '}'                           # setOf
    | '[' binderGroup (',' binderGroup)* '->' expression ']'            # mapOf
    | '[' (expression (',' expression)*)? ']'                           # listOf
    | NONE                                                              # none
    | literal=(TRUE | FALSE | NUMBER)                                   # literal
    | name=id '(' namedArgument (',' namedArgument)* ')'                # recordOf
    | name=id                                                           # name
    | '(' expression ')'                                                # parentheses
    ;

matchCase: name=id ('(' id (',' id)* ')')? '->' expression;

namedArgument: name=id ':=' expression;

// Words that are names where they cannot be anything else.
id
    : ID | ASSUME | TYPE | STATE | START | ACTION | JAVA | MEASURE | RECORD | SET | LIST | OPTION | MAP
    | GIVEN | EVERY | RESTART | PROGRESS | LEADS | TO | FAIR | STRONGLY | AS | FOR | NO | DEADLOCK | UNLESS | LET | CHOOSE
    | REFINES | BY | NOTHING | CONSTRAINT
    ;

AUTOMATON: 'automaton';
ASSUME: 'assume';
PROGRAM: 'program';
PRIMITIVE: 'primitive';
GIVEN: 'given';
EVERY: 'every';
LOCATION: 'location';
WHEN: 'when';
DO: 'do';
GOTO: 'goto';
RESTART: 'restart';
TYPE: 'type';
STATE: 'state';
USES: 'uses';
REFINES: 'refines';
BY: 'by';
NOTHING: 'nothing';
FUN: 'fun';
START: 'start';
ACTION: 'action';
INVARIANT: 'invariant';
CONSTRAINT: 'constraint';
PROGRESS: 'progress';
EVENTUALLY: 'eventually';
LEADS: 'leads';
TO: 'to';
NO: 'no';
DEADLOCK: 'deadlock';
UNLESS: 'unless';
STRONGLY: 'strongly';
FAIR: 'fair';
AS: 'as';
FOR: 'for';
JAVA: 'java';
PRE: 'pre';
EFF: 'eff';
MEASURE: 'measure';
RECORD: 'record';
SET: 'set';
LIST: 'list';
OPTION: 'option';
MAP: 'map';
UNION: 'union';
MINUS: 'minus';
INTERSECT: 'intersect';
MOD: 'mod';
IN: 'in';
SUBSET: 'subset';
DISJOINT: 'disjoint';
IS: 'is';
NOT: 'not';
AND: 'and';
OR: 'or';
FORALL: 'forall';
EXISTS: 'exists';
LET: 'let';
CHOOSE: 'choose';
IF: 'if';
THEN: 'then';
ELSE: 'else';
MATCH: 'match';
NONE: 'none';
TRUE: 'true';
FALSE: 'false';

NUMBER: [0-9]+ ('.' [0-9]+)?;
ID: [A-Za-z] [A-Za-z0-9_]* '?'?;
STRING: '"' ~["\r\n]* '"';
COMMENT: '//' ~[\r\n]* -> channel(HIDDEN);
SPACE: [ \t\r\n]+ -> channel(HIDDEN);
UNKNOWN: .;
