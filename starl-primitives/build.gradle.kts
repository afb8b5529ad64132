plugins {
    `java-library`
    id("maven-publish")
}

description = "Coordination primitives, each with its specification"

dependencies {
    api(project(":starl-core"))
    implementation(libs.jts.core)
    testImplementation(project(":starl-sim"))
    api(libs.jspecify)
    testImplementation(libs.junit.jupiter)
    testImplementation(libs.assertj.core)
    testImplementation(libs.jqwik)
    testRuntimeOnly(libs.junit.platform.launcher)
}
