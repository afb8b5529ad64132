plugins {
    `java-library`
    id("maven-publish")
}

description = "Workloads of the primitives and benchmarks, with the peers that they are compared with"

dependencies {
    api(project(":starl-core"))
    api(project(":starl-core-input"))
    api(project(":starl-primitives"))
    api(project(":starl-sim"))
    api(project(":starl-sim-view"))
    api(project(":starl-apps"))
    api(libs.jspecify)
    testImplementation(project(":starl-lang"))
    testImplementation(libs.archunit)
    testImplementation(libs.junit.jupiter)
    testImplementation(libs.assertj.core)
    testImplementation(libs.jqwik)
    testRuntimeOnly(libs.junit.platform.launcher)
}
